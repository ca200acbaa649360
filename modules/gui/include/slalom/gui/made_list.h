#pragma once

#include <slalom/commands/list_command.h>
#include <slalom/gui/form.h>
#include <slalom/io/scenario_list.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// Where new scenarios are to go unless the user says otherwise.
struct ListTarget {
  bool into_list = true;  ///< a list is open to which they can be added
  std::string file;       ///< for a new list
};

/// Scenarios that a worker made.
struct MadeList {
  std::shared_ptr<ScenarioList> aside;  ///< to be added by add_to_list(); null for a new list
  std::string file;                     ///< of the new list
  std::size_t size = 0;
  std::string report;  ///< lines about how it went; may be empty
};

/// Fields "target" and "file", for forms.
void add_target_fields(FormDescription& form, const ListTarget& target);
/// The new list that they name; empty when they name the open one. Throws Error (Usage) when it is
/// there already.
std::string read_target(const FormValues& values);

/// Fills a new list, or one aside where `file` is empty. The new list stands in its place once it
/// is whole; when `fill` throws, nothing is left of it.
MadeList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill);

/// What a worker added to a list.
struct AddedScenarios {
  std::size_t count = 0;
  std::string first;       ///< hash of the first of them
  ListCommandPtr command;  ///< to be remembered, so that it can be taken back; see make_done()
};

/// Appends what was made aside to the list at `path`, on an opening of its own, for any thread.
/// When `progress` throws, the list stays as it is.
AddedScenarios add_to_list(const std::string& path, const MadeList& made, Progress& progress);

}  // namespace slalom
