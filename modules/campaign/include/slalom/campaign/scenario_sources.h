#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Section [scenarios]: the sources of scenarios. Several sources can be combined.
struct ScenariosSection {
  std::string list;             ///< a .scenarios file
  std::string maps;             ///< map files, comma-separated
  int pairs_per_map = 4;        ///< start and goal pairs sampled on each map
  double min_distance = 4;      ///< m, minimum straight-line distance from start to goal on a map
  std::string generator;        ///< families, comma-separated; options in [generator.NAME]
  std::string weights;          ///< weights of the families, comma-separated; empty: equal
  int count = 60;               ///< scenarios to generate
  bool scale_by_robot = false;  ///< scale lengths by robot radius / kUnscaledRadius
  std::optional<Representation> representation;  ///< of generated scenarios; none: as drawn
  double resolution = 0.05;                      ///< m, of that representation

  void visit(OptionVisitor& v);
};

/// A map as a scenario named after its file, with start and goal at its corner, for sampling starts
/// and goals on it.
Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid);

/// m; with scale_by_robot, lengths of families are multiplied by the robot radius divided by this.
constexpr double kUnscaledRadius = 0.25;

/// The robot and the seed for which scenarios are generated.
struct SourceContext {
  double robot_radius = 0.25;  ///< m
  double resolution = 0.05;    ///< m
  std::uint64_t seed = 1;
  int jobs = 1;  ///< threads; the scenarios do not depend on their number
  /// Computes values to store with generated scenarios; called concurrently.
  std::function<std::vector<KeyedValue>(const World&)> describe = {};
};

/// The sources of scenarios as values.
struct ScenarioSources {
  ScenariosSection section;
  SourceContext context;
  std::vector<WeightedGenerator> families;  ///< those of the section, with their options
};

/// Reads [scenarios] and [generator.NAME]. Throws Error: Usage for a missing or invalid source,
/// File for a map of a family that cannot be read.
ScenarioSources read_scenario_sources(const IniFile& ini, const SourceContext& context,
                                      const MapLoader& load_map);

/// Passes all scenarios of the sources to the sink: those of the list, then start and goal pairs on
/// the maps, then generated ones. They are passed in batches, so that memory does not grow with
/// their number. Every sampled or generated scenario is solvable for the robot. Throws Error: File
/// for a list or map that cannot be read, Job when no solvable scenarios are found.
void stream_scenarios(const ScenarioSources& sources, const MapLoader& load_map, Progress& progress,
                      const GenerationSink& sink);

/// The same in one vector, without duplicates.
std::vector<Scenario> collect_scenarios(const ScenarioSources& sources, const MapLoader& load_map,
                                        Progress& progress);

}  // namespace slalom
