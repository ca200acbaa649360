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
};

const std::vector<ExportFormat>& export_formats();

/// A path without extension gets that of the format. Throws Error (Usage) for an unknown format or
/// another extension.
void export_scenario(const Scenario& scenario, const std::string& format,
                     const MapExportOptions& options, const std::string& path);

}  // namespace slalom
