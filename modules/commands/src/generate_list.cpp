#include <slalom/commands/describe_scenario.h>
#include <slalom/commands/generate_list.h>
#include <slalom/commands/keep_covered.h>
#include <slalom/commands/keep_generated.h>
#include <slalom/commands/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

namespace slalom {
namespace {

/// The families of [scenarios]; coverage has no use for the other sources.
std::vector<std::string> families_of(const IniFile& ini) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  for (const char* key : {"list", "maps", "count", "weights", "scale_by_robot", "representation"})
    if (ini.get("scenarios", key))
      throw usage_error(ini.where("scenarios", key), "does not go with [coverage]",
                        "generator only; the bins say how many");
  std::vector<std::string> families;
  for (const std::string& name : split(section.generator, ','))
    if (!name.empty()) families.push_back(name);
  return families;
}

CoverageTask coverage_task(const IniFile& ini, const GenerationOrder& order,
                           const MapLoader& load_map) {
  CoverageTask task;
  task.seed = order.seed;
  task.robot_radius = read_robot_model(ini).radius;
  task.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  task.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  task.jobs = order.jobs;
  task.load_map = load_map;
  return task;
}

SourceContext source_context(const IniFile& ini, const GenerationOrder& order) {
  const RobotModel robot = read_robot_model(ini);
  SourceContext context;
  context.robot_radius = robot.radius;
  context.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  context.seed = order.seed;
  context.jobs = order.jobs;
  DescribeOptions described;
  described.ids = order.descriptors;
  for (const std::string& id : described.ids) descriptor(id);  // a wrong one is told at once
  described.robot = robot.shape();
  described.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  if (!described.ids.empty())
    context.describe = [described](const World& world) {
      return generated_values(world, described);
    };
  return context;
}

/// Makes each family without reading its map: that it asks for one says that all else is in order.
void check_families(const std::vector<std::string>& families, const IniFile& ini,
                    double length_scale) {
  struct MapAsked {};
  GeneratorContext context;
  context.length_scale = length_scale;
  context.load_map = [](const std::string&) -> mrpt::maps::COccupancyGridMap2D {
    throw MapAsked();
  };
  for (const std::string& family : families) {
    try {
      make_generator(family, ini, context);
    } catch (const MapAsked&) {
    }
  }
}

}  // namespace

std::optional<GeneratedBins> generate_list(ScenarioList& list, const IniFile& ini,
                                           const GenerationOrder& order, const MapLoader& load_map,
                                           Progress& progress) {
  std::optional<GeneratedBins> bins;
  if (ini.has_section("coverage")) {
    bins.emplace();
    bins->plan = read_coverage_plan(ini, families_of(ini));
    bins->result = cover(bins->plan, coverage_task(ini, order, load_map), progress);
    keep_covered(list, bins->plan, bins->result);
  } else {
    stream_scenarios(
        ini, source_context(ini, order), load_map, progress,
        [&](std::vector<GeneratedScenario>& part) { return keep_generated(list, part); });
  }
  list.set_note("origin", "seed " + std::to_string(order.seed) + "\n" + ini.canonical_text());
  return bins;
}

void check_generation(const IniFile& ini, const GenerationOrder& order) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  if (section.list.empty() && section.maps.empty() && section.generator.empty())
    throw usage_error(ini.where("scenarios"), "names no scenarios", "list, maps or generator");
  const SourceContext context = source_context(ini, order);
  check_families(split(section.generator, ','), ini,
                 section.scale_by_robot ? context.robot_radius / kUnscaledRadius : 1);
  if (ini.has_section("coverage")) read_coverage_plan(ini, families_of(ini));
}

}  // namespace slalom
