#pragma once

#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generator.h>
#include <slalom/map_formats/barn.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/point_map.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Which files are to become scenarios, and how; named as the options of `slalom-scenarios import`.
struct ImportRequest {
  /// Maps (see load_map()), point maps, .scenario.yaml, grids or folders of BARN.
  std::vector<std::string> files;
  std::string start, goal;     ///< "x,y,phi" and "x,y" (m, rad) on each map; or empty
  int pairs = 0;               ///< drawn on each map instead
  std::uint64_t seed = 1;      ///< of the pairs
  double robot_radius = 0.25;  ///< m, for whom pairs must be solvable
  TaskLimits limits;           ///< of the pairs
  MapImportOptions map;
  PointMapOptions points;
  BarnOptions barn;
  bool barn_as_grid = false;
  std::string problems;  ///< MovingAI: the file of pairs, of which `pairs` are taken
  std::string buckets;   ///< MovingAI: difficulties, such as "3" or "0-10"

  // All but the files, by what they are about.
  void visit_pairs(OptionVisitor& v);
  void visit_maps(OptionVisitor& v);
  void visit_data_sets(OptionVisitor& v);
  void visit(OptionVisitor& v);
};

struct ImportedScenarios {
  std::vector<Scenario> scenarios;
  /// What the sources say beside them, as notes of a list (key, text).
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> messages;  ///< what was left out, one line each
};

/// Reads the files in their order; tells how many are done. Throws Error: File for what cannot be
/// read, Usage for a map without a task and for wrong places, Job for a pair that the robot cannot
/// solve.
ImportedScenarios import_scenarios(const ImportRequest& request, Progress& progress);

}  // namespace slalom
