// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/io/scenario_list.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <memory>
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
  bool scale_by_robot = false;  ///< scale lengths by the robot's half width / kUnscaledRadius
  std::optional<Representation> representation;  ///< of generated scenarios; none: as drawn
  double resolution = 0.05;                      ///< m, of that representation
  bool goal_headings = false;                    ///< random ones, of generated and sampled goals
  WalkerOptions walkers;                         ///< added to each generated scenario
  PeopleOptions people;                          ///< likewise

  void visit(OptionVisitor& v);
};

/// A map as a scenario named after its file, with start and goal at its corner, for sampling starts
/// and goals on it.
Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid);

/// m; with scale_by_robot, lengths of families are multiplied by the robot's half width divided by
/// this.
constexpr double kUnscaledRadius = 0.25;

/// The robot and the seed for which scenarios are generated.
struct SourceContext {
  double robot_radius = 0.25;                         ///< as in GenerationSettings
  std::optional<Footprint> footprint = std::nullopt;  ///< likewise
  double resolution = 0.05;                           ///< m
  std::uint64_t seed = 1;
  int jobs = 1;  ///< threads; the scenarios do not depend on their number
  /// Computes values to store with generated scenarios; called concurrently.
  std::function<std::vector<KeyedValue>(const World&)> describe = {};
};

/// The same for a robot.
SourceContext source_context(const RobotModel& robot, double resolution, std::uint64_t seed = 1,
                             int jobs = 1);

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

/// Position in the sources at which generation was interrupted.
struct SourceState {
  std::size_t given = 0;   ///< of the list and the maps: those that are finished
  std::size_t passed = 0;  ///< scenarios of the next one that were passed
  MixState mix;            ///< of the families
};

/// The scenarios of the sources part by part, from the beginning or from where they were
/// interrupted: those of the list, then start and goal pairs on the maps, then generated ones. The
/// sources must outlive it.
class ScenarioStream {
 public:
  ScenarioStream(const ScenarioSources& sources, const MapLoader& load_map, SourceState state = {});

  bool finished() const;
  /// The next scenarios; throws as stream_scenarios() does.
  std::vector<GeneratedScenario> next(Progress& progress);
  /// To be called after next(), with the indexes of the duplicates in that part.
  void commit_part(const std::vector<std::size_t>& duplicates);
  const SourceState& state() const { return state_; }

 private:
  const ScenarioSources& sources_;
  MapLoader load_map_;
  SourceState state_;
  std::vector<std::string> given_;      ///< paths: the list, if there is one, and the maps
  std::unique_ptr<ScenarioList> list_;  ///< the list of the sources, once it is open
  std::vector<ScenarioList::Entry> entries_;
  std::optional<MixStream> mix_;  ///< once the given sources are finished
  std::size_t part_ = 0;          ///< size of the last part of a given source
  bool ends_given_ = false;       ///< whether it was the last part

  std::vector<GeneratedScenario> next_of_list();
  std::vector<GeneratedScenario> next_of_map();
  std::vector<GeneratedScenario> next_of_mix(Progress& progress);
};

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
