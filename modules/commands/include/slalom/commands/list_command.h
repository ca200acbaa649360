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

/// One user action on scenario lists that can be taken back (Command). The lists must outlive it.
class ListCommand {
 public:
  virtual ~ListCommand() = default;
  virtual std::string title() const = 0;  ///< for menus and messages, e.g. "Add 12 scenarios"
  /// Why it cannot be done as things are, for a menu to show; empty when it can.
  virtual std::string obstacle() const { return ""; }
  /// All of it or nothing. Throws Error when there is an obstacle that cannot be passed over.
  virtual void execute() = 0;
  /// The lists are as before execute(). Throws Error (Job), with the lists as they are, when
  /// another program has changed the same scenarios since.
  virtual void undo() = 0;
  virtual void redo() = 0;  ///< the lists are as after execute(), without computing anything anew
};

/// What was done, so that it can be taken back step by step and done again.
class CommandHistory {
 public:
  explicit CommandHistory(std::size_t longest = 100) : longest_(longest) {}

  /// Executes and remembers; what had been taken back is forgotten. When it throws, nothing is.
  void execute(std::unique_ptr<ListCommand> command);
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < commands_.size(); }
  std::string undo_title() const;  ///< of what undo() takes back; empty when there is nothing
  std::string redo_title() const;
  void undo();  ///< requires can_undo()
  void redo();  ///< requires can_redo()

 private:
  std::deque<std::unique_ptr<ListCommand>> commands_;
  std::size_t done_ = 0;  ///< of them; the others were taken back
  std::size_t longest_;
};

using ListCommandPtr = std::unique_ptr<ListCommand>;

/// Appends scenarios; those whose content is already there are left out. `origins` holds one for
/// each, or nothing.
ListCommandPtr make_add_scenarios(ScenarioList& list, std::vector<Scenario> scenarios,
                                  std::vector<ScenarioOrigin> origins = {});
ListCommandPtr make_delete_scenarios(ScenarioList& list, ListSelection selection);
/// Appends the chosen ones to `target` with origins, tags and values.
ListCommandPtr make_copy_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target);
/// The same, and removes them from `source`. Killed in between, both lists have them.
ListCommandPtr make_move_scenarios(ScenarioList& source, ListSelection selection,
                                   ScenarioList& target);
/// Copies the chosen ones and the indexes into a list that is not there yet.
ListCommandPtr make_select_into(ScenarioList& source, ListSelection selection, std::string path);
/// Appends all of the sources; equal contents count once.
ListCommandPtr make_merge_lists(std::vector<ScenarioList*> sources, ScenarioList& target);
/// Appends all of a list that was made aside for this, with origins, tags and values. execute()
/// tells `progress`, which may throw to leave the target as it is; the source is let go once all
/// are there.
ListCommandPtr make_add_list(std::shared_ptr<ScenarioList> source, ScenarioList& target,
                             Progress& progress);
/// A command that a worker has executed on `list`, an opening of its own: for the history of who
/// shows that list. Its execute() does nothing.
ListCommandPtr make_done(std::shared_ptr<ScenarioList> list, ListCommandPtr command);
ListCommandPtr make_rename_scenario(ScenarioList& list, std::string hash, std::string name);
/// Puts an edited scenario in another's place.
ListCommandPtr make_edit_scenario(ScenarioList& list, std::string hash, Scenario scenario);
ListCommandPtr make_tag_scenarios(ScenarioList& list, ListSelection selection,
                                  std::vector<std::string> add, std::vector<std::string> remove);
ListCommandPtr make_create_index(ScenarioList& list, ListIndex index);
ListCommandPtr make_drop_index(ScenarioList& list, std::string name);

/// Of scenarios that are too much alike only the first in the list stays. Two are alike when they
/// differ by less than the given amount (> 0) in every one of these descriptors; NA is like NA.
ListCommandPtr make_deduplicate(ScenarioList& list, DescriptorView view,
                                std::vector<std::pair<std::string, double>> least_differences);

struct SplitOptions {
  double held_out = 0.2;  ///< share of scenarios, 0 to 1
  std::uint64_t seed = 1;
};

/// Whether a scenario is held out: by its content and the seed alone, so that it stays on its side
/// whatever else is in the list, and in whatever order.
bool is_held_out(const std::string& hash, const SplitOptions& options);

/// Copies each scenario into one of two lists.
ListCommandPtr make_split(ScenarioList& source, SplitOptions options, ScenarioList& development,
                          ScenarioList& held_out);

}  // namespace slalom
