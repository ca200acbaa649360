// SPDX-License-Identifier: BSD-3-Clause
#include "generation_state.h"
#include "keep_covered.h"
#include "keep_generated.h"

#include <slalom/campaign/describe_scenario.h>
#include <slalom/campaign/scenario_sources.h>
#include <slalom/commands/generate_list.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

namespace slalom {
namespace {

/// The families of [scenarios]. Rejects keys that cannot be combined with [coverage].
std::vector<std::string> families_of(const IniFile& ini) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  for (const char* key : {"list", "maps", "count", "weights", "scale_by_robot", "representation"})
    if (ini.get("scenarios", key))
      throw usage_error(ini.where("scenarios", key), "cannot be combined with [coverage]",
                        "generator, walkers and people only; the bins determine the count");
  return split_nonempty(section.generator, ',');
}

CoverageSettings coverage_settings(const IniFile& ini, const GenerationOptions& options,
                                   const MapLoader& load_map) {
  CoverageSettings settings;
  settings.seed = options.seed;
  const RobotModel robot = read_robot_model(ini);
  settings.robot_radius = robot.radius;
  settings.footprint = robot.turning_polygon();
  settings.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  settings.resolution = read_options<SimulationOptions>(ini, "simulation").resolution;
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  settings.walkers = section.walkers;
  settings.people = section.people;
  settings.jobs = options.jobs;
  settings.load_map = load_map;
  return settings;
}

SourceContext read_context(const IniFile& ini, const GenerationOptions& options) {
  const RobotModel robot = read_robot_model(ini);
  SourceContext context =
      source_context(robot, read_options<SimulationOptions>(ini, "simulation").resolution,
                     options.seed, options.jobs);
  DescribeOptions described;
  described.ids = options.descriptors;
  for (const std::string& id : described.ids) descriptor(id);  // reports an unknown id early
  described.robot = robot.shape();
  described.sensor_range = read_options<SensorModel>(ini, "sensor").max_range;
  if (!described.ids.empty())
    context.describe = [described](const World& world) {
      return generated_values(world, described);
    };
  return context;
}

void fill_from_sources(ScenarioList& list, const ScenarioSources& sources,
                       const MapLoader& load_map, Progress& progress) {
  ScenarioStream stream(sources, load_map, read_source_state(list));
  while (!stream.finished()) {
    const std::vector<GeneratedScenario> part = stream.next(progress);
    list.in_transaction([&] {
      stream.commit_part(keep_generated(list, part));
      store_source_state(list, stream.state());
    });
    if (stream.state().mix.begun > 0)
      progress.advance(static_cast<std::size_t>(stream.state().mix.done()));
  }
  if (!sources.families.empty()) progress.finish();
}

/// Builds each generator without reading its map: a request for the map means that all other
/// options are valid.
void check_families(const std::vector<std::string>& families, const IniFile& ini,
                    double length_scale) {
  struct MapRequested {};
  GeneratorContext context;
  context.length_scale = length_scale;
  context.load_map = [](const std::string&) -> mrpt::maps::COccupancyGridMap2D {
    throw MapRequested();
  };
  for (const std::string& family : families) {
    try {
      make_generator(family, ini, context);
    } catch (const MapRequested&) {
    }
  }
}

}  // namespace

std::optional<GeneratedBins> generate_list(ScenarioList& list, const IniFile& ini,
                                           const GenerationOptions& options,
                                           const MapLoader& load_map, Progress& progress) {
  std::optional<GeneratedBins> bins;
  if (ini.has_section("coverage")) {
    bins.emplace();
    bins->plan = read_coverage_plan(ini, families_of(ini));
    CoverageSettings settings = coverage_settings(ini, options, load_map);
    settings.known = read_evaluations(list);
    settings.keep = [&](const std::string& evaluations) { store_evaluations(list, evaluations); };
    bins->result = cover(bins->plan, settings, progress);
    keep_covered(list, bins->plan, bins->result);
  } else {
    fill_from_sources(list, read_scenario_sources(ini, read_context(ini, options), load_map),
                      load_map, progress);
  }
  list.in_transaction([&] {
    store_end_of_generation(list);
    list.set_note("origin", "seed " + std::to_string(options.seed) + "\n" + ini.canonical_text());
  });
  return bins;
}

void check_generation(const IniFile& ini, const GenerationOptions& options) {
  const auto section = read_options<ScenariosSection>(ini, "scenarios");
  if (section.list.empty() && section.maps.empty() && section.generator.empty())
    throw usage_error(ini.where("scenarios"), "no scenario source given",
                      "list, maps or generator");
  const SourceContext context = read_context(ini, options);
  check_families(split(section.generator, ','), ini,
                 section.scale_by_robot ? context.robot_radius / kUnscaledRadius : 1);
  if (ini.has_section("coverage")) read_coverage_plan(ini, families_of(ini));
}

}  // namespace slalom
