// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/progress.h>
#include <slalom/io/scenario_list.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// An undoable user action on scenario lists (command pattern). The lists must outlive it.
class ListCommand {
 public:
  virtual ~ListCommand() = default;
  virtual std::string title() const = 0;  ///< for menus and messages, e.g. "Add 12 scenarios"
  /// Why the command is currently disabled, for menus; empty when it is enabled.
  virtual std::string disabled_reason() const { return ""; }
  /// Executes the command completely or not at all. Throws Error when it cannot be executed.
  virtual void execute() = 0;
  /// Restores the lists to their state before execute(). Throws Error (Job) and leaves the lists
  /// unchanged when another program has changed the same scenarios since.
  virtual void undo() = 0;
  virtual void redo() = 0;  ///< restores the state after execute() without recomputing it
};

/// The undo and redo history of executed commands.
class CommandHistory {
 public:
  explicit CommandHistory(std::size_t max_length = 100) : max_length_(max_length) {}

  /// Executes the command and appends it, discarding undone commands. Unchanged if it throws.
  void execute(std::unique_ptr<ListCommand> command);
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < commands_.size(); }
  std::string undo_title() const;  ///< of the command that undo() undoes; empty if none
  std::string redo_title() const;
  void undo();  ///< requires can_undo()
  void redo();  ///< requires can_redo()

 private:
  std::deque<std::unique_ptr<ListCommand>> commands_;
  std::size_t done_ = 0;  ///< number of commands that are not undone
  std::size_t max_length_;
};

using ListCommandPtr = std::unique_ptr<ListCommand>;

/// Appends scenarios; scenarios whose content the list already contains are skipped. `origins` has
/// one element per scenario or is empty.
ListCommandPtr make_add_scenarios(ScenarioList& list, std::vector<Scenario> scenarios,
                                  std::vector<ScenarioOrigin> origins = {});
ListCommandPtr make_delete_scenarios(ScenarioList& list, ListSelection selection);
/// Like ScenarioList::restore().
ListCommandPtr make_restore_scenarios(ScenarioList& list, std::vector<std::string> hashes);
/// Appends the selected scenarios to `target` with origins, tags and values.
ListCommandPtr make_copy_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target);
/// The same, and removes them from `source`. If the program is killed in between, both lists
/// contain them.
ListCommandPtr make_move_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target);
/// Copies the selected scenarios and the indexes into a new list.
ListCommandPtr make_select_into(ScenarioList& source, ListSelection selection, std::string path);
/// Appends all scenarios of the sources, without duplicates.
ListCommandPtr make_merge_lists(std::vector<ScenarioList*> sources, ScenarioList& target);
/// Appends all scenarios of a temporary list with origins, tags and values. execute() reports to
/// `progress`, which may throw to cancel and leave the target unchanged; it releases the source
/// when all scenarios are appended.
ListCommandPtr make_add_list(std::shared_ptr<ScenarioList> source, ScenarioList& target,
                             Progress& progress);
/// A command that a background thread has already executed on `list`, its own handle of the file:
/// for the history of the window that shows the file. Its execute() does nothing.
ListCommandPtr make_already_executed(std::shared_ptr<ScenarioList> list, ListCommandPtr command);
ListCommandPtr make_rename_scenario(ScenarioList& list, const std::string& hash,
                                    const std::string& name);
/// Replaces a scenario by its edited version.
ListCommandPtr make_edit_scenario(ScenarioList& list, const std::string& hash,
                                  const Scenario& scenario);
ListCommandPtr make_tag_scenarios(ScenarioList& list, ListSelection selection,
                                  std::vector<std::string> add, std::vector<std::string> remove);
ListCommandPtr make_create_index(ScenarioList& list, ListIndex index);
ListCommandPtr make_drop_index(ScenarioList& list, const std::string& name);

/// Removes near-duplicates, keeping the first in list order. Two scenarios are near-duplicates when
/// they differ by less than the given amount (> 0) in every given descriptor; NA equals NA only.
ListCommandPtr make_deduplicate(ScenarioList& list, DescriptorView view,
                                std::vector<std::pair<std::string, double>> min_differences);

struct SplitOptions {
  double held_out = 0.2;  ///< fraction of scenarios, 0 to 1
  std::uint64_t seed = 1;
};

/// Whether a scenario is held out. Depends on its content and the seed only, not on the other
/// scenarios of the list or their order.
bool is_held_out(const std::string& hash, const SplitOptions& options);

/// Copies each scenario into one of two lists.
ListCommandPtr make_split(ScenarioList& source, SplitOptions options, ScenarioList& development,
                          ScenarioList& held_out);

}  // namespace slalom
