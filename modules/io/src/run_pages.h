#pragma once

#include <slalom/analysis/cell.h>
#include <slalom/io/result_file.h>
#include <slalom/robot/robot_model.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// A group of runs that a table's cell leads to: runs.html#cell-INDEX.
struct RunGroup {
  std::string title;
  std::vector<std::size_t> runs;  ///< indexes into the table's runs
};

/// What the pages of runs are made from.
struct RunPages {
  const ResultFile& file;
  const ResultTable& table;
  const std::vector<Column>& columns;  ///< shown in the list of runs
  const std::vector<RunGroup>& groups;
  const std::map<std::string, std::string>& links;  ///< page and anchor by scenario hash
  RobotModel robot;
  SensorModel sensor;
  double resolution = 0.05;  ///< m, of the model in which runs were judged
};

/// Writes, into a folder that is there, run.html (one run: picture, scan at any moment, clearance,
/// speed, every value), runs.html (many runs, sorted and filtered), their scripts, and the data
/// that they load from data/: runs.js, cells.js and one s-HASH8.js per scenario. A trajectory keeps
/// at most kMostSamples samples, in whole millimetres, milliseconds and milliradians. Throws Error
/// (Job) when it cannot write.
void write_run_pages(const RunPages& pages, const std::string& directory);

constexpr std::size_t kMostSamples = 80;

/// Places of the runs in the table by the hash of their scenario, in the order of the table.
std::map<std::string, std::vector<std::size_t>> runs_by_scenario(const ResultTable& table);

/// "run.html#HASH8/METHOD/REPETITION", percent-encoded.
std::string run_link(const RunRecord& run);

}  // namespace slalom
