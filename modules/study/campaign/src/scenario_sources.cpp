// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

/// The name of a map: its file name without folders, ".gz" and the extension.
std::string map_name(const std::string& path) {
  const std::filesystem::path file(path);
  return (file.extension() == ".gz" ? file.stem() : file).stem().string();
}

std::vector<double> read_weights(const IniFile& ini, const ScenariosSection& section,
                                 std::size_t count) {
  const std::vector<std::string> texts = split(section.weights, ',');
  std::vector<double> weights(count, 1);
  bool good = texts.empty() || texts.size() == count;
  for (std::size_t i = 0; good && i < texts.size(); ++i)
    good = parse_number(texts[i], weights[i]) && weights[i] > 0 && weights[i] <= 1e9;
  if (!good)
    throw usage_error(ini.where("scenarios", "weights"), "'" + section.weights + "'",
                      "a positive number for each generator");
  return weights;
}

void require_known(const std::string& family, const std::string& where) {
  const std::vector<std::string> known = generator_names();
  if (!contains(known, family))
    throw usage_error(where, "unknown generator '" + family + "'", expected_name(family, known));
}

/// Rejects option sections of unknown families.
void refuse_unknown_families(const IniFile& ini) {
  const std::string prefix = "generator.";
  for (const std::string& section : ini.sections()) {
    if (starts_with(section, prefix))
      require_known(section.substr(prefix.size()), ini.where(section));
  }
}

std::vector<WeightedGenerator> read_mix(const IniFile& ini, const ScenariosSection& section,
                                        const SourceContext& context, const MapLoader& load_map) {
  refuse_unknown_families(ini);
  GeneratorContext families;
  families.load_map = load_map;
  if (section.scale_by_robot)
    families.length_scale =
        passing_radius(context.robot_radius, context.footprint) / kUnscaledRadius;
  const std::vector<std::string> names = split(section.generator, ',');
  const std::vector<double> weights = read_weights(ini, section, names.size());
  std::vector<WeightedGenerator> mix;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1)
      throw usage_error(ini.where("scenarios", "generator"), "duplicate family '" + names[i] + "'",
                        "each family once");
    require_known(names[i], ini.where("scenarios", "generator"));
    mix.push_back({make_generator(names[i], ini, families), weights[i],
                   source_seed(context.seed, names[i]), names[i]});
  }
  return mix;
}

/// Checks options of walkers or people, the keys of which begin with `one`.
template <typename Options>
void check_moving(const IniFile& ini, const ScenariosSection& section, const Options& options,
                  const std::string& all, const std::string& one) {
  if (options.count > 0 && section.generator.empty())
    throw usage_error(ini.where("scenarios", all), all + " without a generator",
                      "generator: " + all + " are added to generated scenarios only");
  if (options.min_radius > options.max_radius)
    throw usage_error(ini.where("scenarios", one + "_min_radius"), "exceeds " + one + "_max_radius",
                      "at most " + format_number(options.max_radius) + " m");
  if (options.min_speed > options.max_speed)
    throw usage_error(ini.where("scenarios", one + "_min_speed"), "exceeds " + one + "_max_speed",
                      "at most " + format_number(options.max_speed) + " m/s");
}

}  // namespace

Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid) {
  const mrpt::math::TPoint2D corner(grid.getXMin(), grid.getYMin());
  return Scenario::grid(map_name(path), grid, {corner.x, corner.y, 0}, corner);
}

void ScenariosSection::visit(OptionVisitor& v) {
  v.option("list", list, "a scenario list (.scenarios)");
  v.option("maps", maps, "map files, comma-separated: MRPT gridmap or simplemap, ROS map YAML");
  v.option("pairs_per_map", pairs_per_map, "-", "start and goal pairs sampled on each map",
           Range::between(1, 1e6));
  v.option("min_distance", min_distance, "m",
           "minimum straight-line distance from start to goal on a map", Range::at_least(0));
  v.option("generator", generator,
           "families, comma-separated; their options are in [generator.NAME]");
  v.option("weights", weights, "weights of the families, comma-separated; empty: equal");
  v.option("count", count, "-", "scenarios to generate", Range::between(1, 1e7));
  v.option("scale_by_robot", scale_by_robot,
           "multiply all lengths of the families by half the width of the robot / 0.25 m");
  v.option("representation", representation, "representation of generated scenarios", "as_drawn");
  v.option("resolution", resolution, "m", "cell size or point spacing of that representation",
           Range::positive());
  v.option("goal_headings", goal_headings,
           "generated goals, and those sampled on maps, have random headings");
  v.option("walkers", walkers.count, "-", "moving obstacles in each generated scenario",
           Range::between(0, 1000));
  v.option("walker_min_radius", walkers.min_radius, "m", "smallest radius of a walker",
           Range::positive());
  v.option("walker_max_radius", walkers.max_radius, "m", "largest radius of a walker",
           Range::positive());
  v.option("walker_min_speed", walkers.min_speed, "m/s", "lowest speed of a walker",
           Range::between(0.01, 100));
  v.option("walker_max_speed", walkers.max_speed, "m/s", "highest speed of a walker",
           Range::between(0.01, 100));
  v.option("people", people.count, "-", "people, who react, in each generated scenario",
           Range::between(0, 1000));
  v.option("person_min_radius", people.min_radius, "m", "smallest radius of a person",
           Range::positive());
  v.option("person_max_radius", people.max_radius, "m", "largest radius of a person",
           Range::positive());
  v.option("person_min_speed", people.min_speed, "m/s", "lowest preferred speed of a person",
           Range::between(0.01, 100));
  v.option("person_max_speed", people.max_speed, "m/s", "highest preferred speed of a person",
           Range::between(0.01, 100));
}

SourceContext source_context(const RobotModel& robot, double resolution, std::uint64_t seed,
                             int jobs) {
  return {robot.radius, robot.turning_polygon(), resolution, seed, jobs};
}

ScenarioSources read_scenario_sources(const IniFile& ini, const SourceContext& context,
                                      const MapLoader& load_map) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  if (section.list.empty() && section.maps.empty() && section.generator.empty())
    throw usage_error(ini.where("scenarios"), "no scenario source given",
                      "list, maps or generator");
  check_moving(ini, section, section.walkers, "walkers", "walker");
  check_moving(ini, section, section.people, "people", "person");
  return {section, context, read_mix(ini, section, context, load_map)};
}

}  // namespace slalom
