#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Section [scenarios]: where the scenarios of a campaign come from. Several sources may be named.
struct ScenariosSection {
  std::string list;         ///< a .scenarios file
  std::string maps;         ///< map files, comma separated
  int pairs_per_map = 4;    ///< start and goal pairs drawn on each map
  double min_distance = 4;  ///< m, straight distance from start to goal on a map
  std::string generator;    ///< families, comma separated; their options stand in [generator.NAME]
  std::string weights;      ///< their shares, comma separated; empty: equal ones
  int count = 60;           ///< scenarios to generate
  bool scale_by_robot = false;  ///< lengths of families are for a robot of kUnscaledRadius
  std::string representation = "as_drawn";  ///< of generated scenarios
  double resolution = 0.05;                 ///< m, of that representation

  void visit(OptionVisitor& v);
};

/// A map as a scenario named after its file, start and goal still at its corner: for drawing tasks
/// on it.
Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid);

/// With scale_by_robot, lengths of families are multiplied by the robot's radius over this (m).
constexpr double kUnscaledRadius = 0.25;

/// For whom scenarios are made, and from which seed.
struct SourceContext {
  double robot_radius = 0.25;  ///< m
  double resolution = 0.05;    ///< m
  std::uint64_t seed = 1;
  int jobs = 1;  ///< threads that generate; scenarios are the same for any number
  /// Values to keep with generated scenarios; called by several threads at once.
  std::function<std::vector<GeneratedValue>(const World&)> describe = {};
};

/// Gives all scenarios that [scenarios] names to the sink: those of the list, then pairs on the
/// maps, then generated ones in parts, so that memory does not grow with their number. Every drawn
/// or generated one is solvable for the robot. Throws Error: Usage when the section names no source
/// or a wrong one, File for a list or map that cannot be read, Job when solvable scenarios cannot
/// be found; wrong options are told before anything is made.
void stream_scenarios(const IniFile& ini, const SourceContext& context, const MapLoader& load_map,
                      Progress& progress, const GenerationSink& sink);

/// The same as a whole; equal contents only once.
std::vector<Scenario> collect_scenarios(const IniFile& ini, const SourceContext& context,
                                        const MapLoader& load_map, Progress& progress);

}  // namespace slalom
