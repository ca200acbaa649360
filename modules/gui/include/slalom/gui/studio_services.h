#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generator.h>
#include <slalom/gui/option_fields.h>
#include <slalom/scenario/scenario.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// What the window needs from foreign formats; the program hands it over. All are called on
/// workers and may throw Error.
struct StudioServices {
  MapLoader load_map;  ///< for families on real maps

  /// Options of imports by what they are about (title, options); all stand in section [import].
  std::vector<std::pair<std::string, VisitOptions>> import_options;

  struct ImportedFiles {
    std::vector<Scenario> scenarios;
    std::vector<std::pair<std::string, std::string>> notes;  ///< of a list that has them alone
    std::vector<std::string> messages;                       ///< what was left out
  };
  std::function<ImportedFiles(const std::vector<std::string>& files, const IniFile& options,
                              Progress& progress)>
      import_files;

  struct Format {
    std::string name, ending, content;
  };
  std::vector<Format> export_formats;
  /// A path without an extension gets that of the format; `resolution` (m) is for formats with
  /// cells where the scenario has none.
  std::function<void(const Scenario& scenario, const std::string& format, double resolution,
                     const std::string& path)>
      export_scenario;
};

}  // namespace slalom
