#pragma once

#include <slalom/scenario/scenario.h>

#include <string>
#include <vector>

namespace slalom {

/// How scenarios become files of other programs.
struct MapExportOptions {
  double resolution = 0.05;  ///< m, of cells where the format has cells and the scenario has none
};

/// One format that scenarios are written in. All writers write temporary files and rename them, and
/// throw Error (Job) when they cannot. What a map has no place for (name, start, goal) goes into a
/// task file beside it (see map_task.h).
struct ExportFormat {
  std::string name;     ///< as on the command line
  std::string ending;   ///< of its files
  std::string content;  ///< what is written, for people
  void (*write)(const Scenario& scenario, const MapExportOptions& options, const std::string& path);
};

const std::vector<ExportFormat>& export_formats();

/// A path without an extension gets that of the format. Throws Error (Usage) when there is no such
/// format or the path ends otherwise than its files do.
void export_scenario(const Scenario& scenario, const std::string& format,
                     const MapExportOptions& options, const std::string& path);

}  // namespace slalom
