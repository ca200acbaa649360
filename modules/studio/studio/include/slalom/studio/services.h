// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/core/progress.h>
#include <slalom/generation/generator.h>
#include <slalom/scenario/scenario.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Visits options that have their default values, like visit_generator_options().
using VisitOptions = std::function<void(OptionVisitor&)>;

/// Import and export functions that the program provides to the window. They are called in worker
/// threads and may throw Error.
struct StudioServices {
  MapLoader load_map;  ///< for families based on maps

  /// Import options in groups (title, options); all belong to section [import].
  std::vector<std::pair<std::string, VisitOptions>> import_options;

  struct ImportedFiles {
    std::vector<Scenario> scenarios;
    std::vector<std::pair<std::string, std::string>> notes;  ///< for a list of only these
    std::vector<std::string> messages;                       ///< about skipped input
  };
  std::function<ImportedFiles(const std::vector<std::string>& files, const IniFile& options,
                              Progress& progress)>
      import_files;

  struct Format {
    std::string name, extension, content;
  };
  std::vector<Format> export_formats;
  /// Adds the extension of the format if `path` has none. `resolution` (m) is the cell size for
  /// formats with cells if the scenario has none. Returns what of the scenario the format cannot
  /// hold, in one line; empty if nothing.
  std::function<std::string(const Scenario& scenario, const std::string& format, double resolution,
                            const std::string& path)>
      export_scenario;

  struct ShrinkRequest {
    std::string results, run;  ///< a result file, and the id of a run that failed
    std::string folder;        ///< for all that is written
    std::string max_runs;
    bool requires_witness = true;
    bool trust = false;  ///< execute the libraries, modules and commands that the results name
  };
  /// Writes the smallest scenario that reproduces the failure to the list failures.scenarios in
  /// the folder. Returns a summary for the user. Null if the program cannot shrink.
  std::function<std::string(const ShrinkRequest& request, Progress& progress)> shrink_run;

  struct RunRequest {
    std::string campaign;  ///< an .ini, or a result file that contains one
    bool trust = false;    ///< execute the libraries, modules and commands that results name
    std::string list;      ///< with the scenarios
    std::string results;   ///< a new file, which has the ended runs also after an error
  };
  /// Runs all methods of a campaign. Null if the program cannot run methods.
  std::function<void(const RunRequest& request, Progress& progress)> run_methods;
  /// The .ini whose methods are run unless the user chooses another; empty: that of the results.
  std::string campaign;

  /// Returns a folder with campaign.scenarios and runs.results of the campaign that comes with the
  /// programs. Null if the program cannot run it.
  std::function<std::string(Progress& progress)> make_demo;

  struct SearchRequest {
    std::string campaign, method;  ///< an .ini, and the method of it that is tested
    std::string folder;            ///< for all that is written
    std::string runs, failures;    ///< at most
    bool all_outcomes = false;     ///< also stuck and timeout are failures
    bool requires_witness = true;
  };
  /// Writes the smallest scenarios in which the method fails to the list failures.scenarios in the
  /// folder. Returns a summary for the user. Null if the program cannot search.
  std::function<std::string(const SearchRequest& request, Progress& progress)> search_failures;
};

}  // namespace slalom
