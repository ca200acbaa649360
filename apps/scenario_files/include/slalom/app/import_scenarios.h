// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generator.h>
#include <slalom/map_formats/barn.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/point_map.h>
#include <slalom/rawlog/log_objects.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The files to import, and the import options, named like those of `slalom-scenarios import`.
struct ImportRequest {
  /// Maps (see load_map()), point maps, worlds, .scenario.yaml, grids or folders of BARN, logs.
  std::vector<std::string> files;
  std::string start, goal;     ///< "x,y,phi" and "x,y[,phi]" (m, rad) on each map; or empty
  std::string pairs;           ///< number to sample on each map instead, or a file of pairs
  std::uint64_t seed = 1;      ///< of the pairs
  double robot_radius = 0.25;  ///< m; pairs must be solvable for it
  TaskConstraints limits;      ///< of the pairs
  MapImportOptions map;
  PointMapOptions points;
  BarnOptions barn;
  bool barn_as_grid = false;
  BagSelection topics;   ///< of bags
  std::string problems;  ///< MovingAI: the file of pairs, of which `pairs` are taken
  std::string buckets;   ///< MovingAI: difficulties, such as "3" or "0-10"

  // All options except the files, by topic.
  void visit_pairs(OptionVisitor& v);
  void visit_maps(OptionVisitor& v);
  void visit_data_sets(OptionVisitor& v);
  void visit(OptionVisitor& v);
};

struct ImportedScenarios {
  std::vector<Scenario> scenarios;
  /// Additional information from the files, as notes of a list (key, text).
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> messages;  ///< one line per file about left out scenarios
};

/// The number of pairs to sample on each map; 0 if `pairs` is a file. Throws Error (Usage).
int sampled_pairs(const ImportRequest& request);

/// Imports the files in order and reports progress. Throws Error: File for unreadable files, Usage
/// for a map or log without start and goal and for invalid poses, Job for an unsolvable pair.
ImportedScenarios import_scenarios(const ImportRequest& request, Progress& progress);

}  // namespace slalom
