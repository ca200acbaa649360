// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <string>
#include <vector>

namespace slalom {

/// Options of exporting scenarios to files of other programs.
struct MapExportOptions {
  double resolution = 0.05;  ///< m, if the format has cells and the scenario has none
};

/// One export format of scenarios. All writers write temporary files and rename them, and throw
/// Error (Job) on failure. Properties that a map cannot store (name, start, goal) are written to a
/// task file next to it (see map_task.h).
struct ExportFormat {
  std::string name;     ///< as on the command line
  std::string ending;   ///< of its file names
  std::string content;  ///< human-readable description
  void (*write)(const Scenario& scenario, const MapExportOptions& options, const std::string& path);
  bool has_movers = false;  ///< moving obstacles are exported, too
  bool has_people = false;  ///< people, too
};

const std::vector<ExportFormat>& export_formats();

/// A path without extension gets that of the format. The result is what of the scenario the format
/// cannot hold, in one line, "" if nothing. Throws Error (Usage) for an unknown format or another
/// extension.
std::string export_scenario(const Scenario& scenario, const std::string& format,
                            const MapExportOptions& options, const std::string& path);

}  // namespace slalom
