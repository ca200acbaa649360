#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generator.h>
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
  std::string generator;    ///< its options stand in [generator.NAME]
  int count = 60;           ///< scenarios to generate

  void visit(OptionVisitor& v);
};

/// A map as a scenario named after its file, start and goal still at its corner: for drawing tasks
/// on it.
Scenario map_scenario(const std::string& path, const mrpt::maps::COccupancyGridMap2D& grid);

/// For whom scenarios are made, and from which seed.
struct SourceContext {
  double robot_radius = 0.25;  ///< m
  double resolution = 0.05;    ///< m
  std::uint64_t seed = 1;
};

/// All scenarios that [scenarios] names: those of the list, then pairs on the maps, then generated
/// ones; equal contents only once. Every drawn or generated one is solvable for the robot. Throws
/// Error: Usage when the section names no source or a wrong one, File for a list or map that cannot
/// be read, Job when solvable scenarios cannot be found.
std::vector<Scenario> collect_scenarios(const IniFile& ini, const SourceContext& context,
                                        const MapLoader& load_map, Progress& progress);

}  // namespace slalom
