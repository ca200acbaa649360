#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

/// The name of a map: its file name without folders, ".gz" and the extension.
std::string map_name(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  if (file.size() > 3 && file.compare(file.size() - 3, 3, ".gz") == 0) file.resize(file.size() - 3);
  return file.substr(0, file.rfind('.'));
}

GenerationTask task_for(const SourceContext& context, int count, const std::string& name) {
  GenerationTask task;
  task.count = count;
  task.seed = derive_seed(context.seed, "scenarios/" + name);
  task.robot_radius = context.robot_radius;
  task.resolution = context.resolution;
  task.name_prefix = name;
  return task;
}

void give_list(const std::string& path, const GenerationSink& sink) {
  const ScenarioList list = ScenarioList::open(path);
  constexpr std::size_t kAtOnce = 128;
  std::vector<GeneratedScenario> part;
  for (const auto& entry : list.entries()) {
    part.push_back({list.read(entry.hash), entry.generator, entry.seed});
    if (part.size() < kAtOnce) continue;
    sink(part);
    part.clear();
  }
  sink(part);
}

void give_map(const std::string& path, const ScenariosSection& section,
              const SourceContext& context, const MapLoader& load_map, const GenerationSink& sink) {
  const Scenario map = map_scenario(path, load_map(path));
  const GenerationTask task = task_for(context, section.pairs_per_map, map.name());
  std::vector<GeneratedScenario> part;
  for (Scenario& scenario : draw_tasks(map, task, section.min_distance))
    part.push_back({std::move(scenario), "", std::nullopt});
  sink(part);
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
                      "a number above 0 for each generator");
  return weights;
}

/// Sections of options of families that do not exist.
void refuse_unknown_families(const IniFile& ini) {
  const std::string prefix = "generator.";
  const std::vector<std::string> known = generator_names();
  for (const std::string& section : ini.sections()) {
    if (section.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string family = section.substr(prefix.size());
    if (std::find(known.begin(), known.end(), family) != known.end()) continue;
    const std::string nearest = nearest_name(family, known);
    throw usage_error(ini.where(section), "unknown generator '" + family + "'",
                      nearest.empty() ? "one of " + join(known, ", ") : "'" + nearest + "'");
  }
}

std::vector<GeneratorShare> read_mix(const IniFile& ini, const ScenariosSection& section,
                                     const SourceContext& context, const MapLoader& load_map) {
  refuse_unknown_families(ini);
  GeneratorContext families;
  families.load_map = load_map;
  if (section.scale_by_robot) families.length_scale = context.robot_radius / kUnscaledRadius;
  const std::vector<std::string> names = split(section.generator, ',');
  const std::vector<double> weights = read_weights(ini, section, names.size());
  std::vector<GeneratorShare> mix;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1)
      throw usage_error(ini.where("scenarios", "generator"), "names " + names[i] + " twice",
                        "each family once");
    mix.push_back({make_generator(names[i], ini, families), weights[i],
                   task_for(context, section.count, names[i]).seed, names[i]});
  }
  return mix;
}

MixTask mix_task(const ScenariosSection& section, const SourceContext& context) {
  MixTask task;
  task.each = task_for(context, section.count, "");
  task.jobs = context.jobs;
  if (section.representation != "as_drawn")
    task.representation = representation_from_string(section.representation);
  task.conversion_resolution = section.resolution;
  task.describe = context.describe;
  return task;
}

}  // namespace

Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid) {
  const mrpt::math::TPoint2D corner(grid.getXMin(), grid.getYMin());
  return Scenario::grid(map_name(path), grid, {corner.x, corner.y, 0}, corner);
}

void ScenariosSection::visit(OptionVisitor& v) {
  v.option("list", list, "a scenario list (.scenarios)");
  v.option("maps", maps, "map files, comma separated: MRPT gridmap or simplemap, ROS map YAML");
  v.option("pairs_per_map", pairs_per_map, "-", "start and goal pairs drawn on each map",
           Range::between(1, 1e6));
  v.option("min_distance", min_distance, "m", "straight distance from start to goal on a map",
           Range::at_least(0));
  v.option("generator", generator,
           "families, comma separated, whose options stand in [generator.NAME]");
  v.option("weights", weights, "shares of these families, comma separated; empty: equal");
  v.option("count", count, "-", "scenarios to generate", Range::between(1, 1e7));
  v.option("scale_by_robot", scale_by_robot,
           "multiply all lengths of families by the robot's radius over 0.25 m");
  v.option("representation", representation, "of generated scenarios",
           {"as_drawn", "continuous", "grid", "points"});
  v.option("resolution", resolution, "m", "cells or spacing of points of that representation",
           Range::positive());
}

void stream_scenarios(const IniFile& ini, const SourceContext& context, const MapLoader& load_map,
                      Progress& progress, const GenerationSink& sink) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  if (section.list.empty() && section.maps.empty() && section.generator.empty())
    throw usage_error(ini.where("scenarios"), "names no scenarios", "list, maps or generator");
  const std::vector<GeneratorShare> mix = read_mix(ini, section, context, load_map);
  if (!section.list.empty()) give_list(section.list, sink);
  for (const std::string& path : split(section.maps, ','))
    give_map(path, section, context, load_map, sink);
  if (!mix.empty()) generate_mix(mix, mix_task(section, context), progress, sink);
}

std::vector<Scenario> collect_scenarios(const IniFile& ini, const SourceContext& context,
                                        const MapLoader& load_map, Progress& progress) {
  DistinctScenarios distinct;
  stream_scenarios(ini, context, load_map, progress,
                   [&](std::vector<GeneratedScenario>& part) { return distinct.add(part); });
  return distinct.take();
}

}  // namespace slalom
