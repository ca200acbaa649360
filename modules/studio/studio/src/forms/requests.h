// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/generate_list.h>
#include <slalom/commands/list_command.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/io/scenario_list.h>
#include <slalom/results/run_record.h>
#include <slalom/studio/form.h>
#include <slalom/studio/services.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// A field for each option, with its default, except for the keys in `without`. Its key is
/// "PREFIX.KEY", or "KEY" without a prefix. A field with an infinite default is empty and optional.
std::vector<FormField> option_fields(const VisitOptions& visit, const std::string& prefix,
                                     const std::vector<std::string>& without = {});

/// Writes the fields whose values differ from the default to [section].
void put_options(IniFile& ini, const std::string& section, const std::string& prefix,
                 const std::vector<FormField>& fields, const FormValues& values);

/// The default target of new scenarios.
struct ListTarget {
  bool into_list = true;  ///< append to an open list
  std::string file;       ///< of a new list
};

/// Scenarios that were generated or imported by a worker thread.
struct NewList {
  std::shared_ptr<ScenarioList> staging;  ///< for add_to_list(); null for a new list
  std::string file;                       ///< of the new list
  std::size_t size = 0;
  std::string report;  ///< summary lines for the user; may be empty
};

/// Adds the fields "target" and "file" to a form.
void add_target_fields(FormDescription& form, const ListTarget& target);
/// The path of the new list from these fields; empty for the open list. Throws Error (Usage) when
/// the file already exists.
std::string read_target(const FormValues& values);

/// Fills a new list, or a temporary staging list if `file` is empty. The file appears when the list
/// is complete; when `fill` throws, no file is left.
NewList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill);

/// Scenarios that a worker thread added to a list.
struct AddedScenarios {
  std::size_t count = 0;
  std::string first;       ///< hash of the first of them
  ListCommandPtr command;  ///< for the undo history; see make_already_executed()
};

/// Appends the staging list to the list at `path`, which it opens itself; may run in any thread.
/// When `progress` throws, the list is unchanged.
AddedScenarios add_to_list(const std::string& path, const NewList& made, Progress& progress);

/// Defaults of the generation forms: the robot, its sensor and the target list.
struct GenerationDefaults {
  double robot_radius = 0.25;  ///< m
  double sensor_range = 8;     ///< m
  double resolution = 0.05;    ///< m
  ListTarget target;
};

/// A generation requested by the user, with the same input as `slalom-scenarios generate`.
struct GenerationRequest {
  IniFile ini;
  GenerationOptions order;
  std::string file;  ///< of the new list; empty: append to an open list
};

/// Form for families with all their options, number and seed.
FormDescription random_generation_form(const GenerationDefaults& defaults);
/// Form for descriptors with their bins, and the budget of the search.
FormDescription bins_generation_form(const GenerationDefaults& defaults);

/// Throw Error (Usage) with section and key like check_generation(), or when the new list already
/// exists.
GenerationRequest read_random_generation(const FormValues& values);
GenerationRequest read_bins_generation(const FormValues& values);

/// Generates the scenarios; may run in any thread. When `progress` throws to cancel, no file is
/// left. For a generation by bins the report is the table of bins.
NewList generate(const GenerationRequest& request, const MapLoader& load_map, Progress& progress);

/// An import requested by the user.
struct FileImport {
  std::vector<std::string> files;
  IniFile options;   ///< section [import]
  std::string file;  ///< of the new list; empty: append to an open list
};

/// Form for the files, the import options and the target list.
FormDescription import_form(const StudioServices& services, const ListTarget& target,
                            const std::vector<std::string>& files);
/// Throws Error (Usage) when no file is given, a file does not exist, or the new list does.
FileImport read_import(const StudioServices& services, const FormValues& values);
/// Imports the files; may run in any thread. Cancels like generate().
NewList import_into_list(const StudioServices& services, const FileImport& request,
                         Progress& progress);

/// Form to shrink a run, with a proposed folder.
FormDescription shrink_form(const RunRecord& run, const std::string& folder);
/// Throws Error (Usage) when the folder exists.
StudioServices::ShrinkRequest read_shrink(const std::string& results, const RunRecord& run,
                                          const FormValues& values);
/// Shrinks the run; may run in any thread. When `progress` throws, what was begun is ended.
NewList shrink_into_list(const StudioServices& services,
                         const StudioServices::ShrinkRequest& request, Progress& progress);

/// Form to search failures of a method, with a proposed folder.
FormDescription search_form(const std::string& folder);
/// Throws Error (Usage) when the campaign does not exist.
StudioServices::SearchRequest read_search(const FormValues& values);
/// Searches; may run in any thread. When `progress` throws, the search is ended and can be
/// continued. Without a failure the file of the result is empty.
NewList search_into_list(const StudioServices& services,
                         const StudioServices::SearchRequest& request, Progress& progress);

/// Form for format, resolution and file of an exported scenario.
FormDescription export_form(const StudioServices& services, const Scenario& scenario,
                            double resolution);
/// Throws Error (Usage) when the file exists and Replace is not set.
void check_export(const StudioServices& services, const FormValues& values);
/// Returns what the format could not hold, as StudioServices::export_scenario.
std::string export_as(const StudioServices& services, const Scenario& scenario,
                      const FormValues& values);

/// Form for id, radius, waypoints and end of each mover of a scenario, one at a time.
FormDescription movers_form(const Scenario& scenario);
/// The scenario with the movers of the form. Throws Error (Usage) for waypoints that are not such,
/// and as check_movers() does.
Scenario read_movers(const Scenario& scenario, const FormValues& values);

/// Form for id, radius, speed, start, route, begin and end of each person, like that for movers.
FormDescription people_form(const Scenario& scenario);
Scenario read_people(const Scenario& scenario, const FormValues& values);

}  // namespace slalom
