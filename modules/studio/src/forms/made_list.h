#pragma once

#include <slalom/commands/list_command.h>
#include <slalom/io/scenario_list.h>
#include <slalom/studio/form.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// The default target of new scenarios.
struct ListTarget {
  bool into_list = true;  ///< append to an open list
  std::string file;       ///< of a new list
};

/// Scenarios that were generated or imported by a worker thread.
struct MadeList {
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
MadeList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill);

/// Scenarios that a worker thread added to a list.
struct AddedScenarios {
  std::size_t count = 0;
  std::string first;       ///< hash of the first of them
  ListCommandPtr command;  ///< for the undo history; see make_already_executed()
};

/// Appends the staging list to the list at `path`, which it opens itself; may run in any thread.
/// When `progress` throws, the list is unchanged.
AddedScenarios add_to_list(const std::string& path, const MadeList& made, Progress& progress);

}  // namespace slalom
