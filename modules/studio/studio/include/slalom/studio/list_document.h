// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/list_command.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/studio/list_view.h>
#include <slalom/studio/studio_events.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace slalom {

class Jobs;

/// Content of a row of a list, besides the thumbnail.
struct ListRow {
  ScenarioList::Entry entry;
  std::optional<Value> value;  ///< of the sort field; none if not computed
  std::string outcomes = {};   ///< if the list is sorted by them; empty for none
};

/// Actions on an open list.
enum class ListAction {
  Undo,
  Redo,
  CopyTo,
  MoveTo,
  Remove,
  Restore,
  Rename,
  Tag,
  SaveAs,
  CreateIndex,
  DropIndex,
  Deduplicate
};

/// An open scenario list: its view, selection, current scenario and undo history. Independent of
/// the window. Not thread-safe.
class ListDocument {
 public:
  /// Opens the list; the view is empty before refresh(). Views of long lists are computed by `jobs`
  /// if given. Throws like ScenarioList::open().
  explicit ListDocument(const std::string& path, Jobs* jobs = nullptr);
  ~ListDocument();
  ListDocument(const ListDocument&) = delete;
  ListDocument& operator=(const ListDocument&) = delete;

  const std::string& path() const { return path_; }
  std::string title() const;  ///< the file name
  ScenarioList& list() { return *list_; }
  CommandHistory& history() { return history_; }

  /// `observer` is called with Change::Current and Change::View after they may have changed, with
  /// Change::CurrentRow when the current scenario was put into another row, with
  /// Change::CurrentLost before another one takes its place, and with Change::Command after a
  /// command.
  void observe(std::function<void(Change)> observer) { observer_ = std::move(observer); }

  // The view. Each setter recomputes it.
  const ListViewRequest& request() const { return request_; }
  /// An invalid filter sets filter_error() and leaves the view unchanged.
  void set_filter(const std::string& text);
  void restore_filter();  ///< forgets an invalid filter: that of the view is shown again
  void set_sort(const std::string& field, bool descending);
  const std::string& sort_unit() const { return sort_unit_; }  ///< "-" for none
  void set_group_by(const std::string& index);
  /// The robot and sensor of the descriptor values that filters and sorting use.
  void set_describe_options(const DescribeOptions& options);
  /// Results that filters and sorting may use; null for none.
  void set_results(std::shared_ptr<const ResultFields> results);
  const std::string& filter_text() const { return filter_text_; }  ///< as last set
  const std::string& filter_error() const { return filter_error_; }
  const std::string& notice() const { return notice_; }  ///< a change of the file, if any
  bool is_computing() const;                             ///< a view is being computed
  void refresh();                                        ///< after a change of the list
  /// Stores computed values of a scenario, which put an edited one where it belongs; no effect if
  /// the list does not contain it.
  void store_values(const std::string& hash, const std::vector<KeyedValue>& values);
  const ListView& view() const { return view_; }
  const ListLines& lines() const { return lines_; }
  void toggle_group(std::size_t group);
  /// Read on first use and cached. Null if the list no longer contains the scenario.
  const ListRow* row(const std::string& hash);
  std::vector<ListIndex> indexes() const { return list_->indexes(); }

  // Current and selected scenarios, by their index in the view.
  const std::string& current() const { return current_; }
  /// Ignored when the scenario is neither in the view nor in the one being computed.
  void set_current(const std::string& hash);
  bool is_selected(std::size_t index) const { return is_selected_[index] != 0; }
  std::size_t selected_count() const { return selected_; }
  std::vector<std::string> selected() const;  ///< hashes, in view order; never in closed groups
  void select_only(std::size_t index);        ///< on a click
  void toggle(std::size_t index);             ///< on Ctrl+click
  void select_to(std::size_t index);          ///< on Shift+click: from the last click to here
  void select_all();
  void select_none();
  void select(const std::vector<std::string>& hashes);  ///< those in the view

  /// Change of the file by another program since the last check.
  enum class FileState { Same, Changed, Replaced, Gone };
  FileState file_state() const;
  /// Reloads a changed file. Returns what happened, empty for nothing; notice() keeps what lasts.
  std::string update_from_file();

  // Actions. They throw Error with the disabled_reason() if any, and the errors of the list.
  std::string disabled_reason(ListAction action) const;  ///< empty if enabled
  void copy_to(ListDocument& target);
  void move_to(ListDocument& target);
  void remove_selected();
  void restore(const std::vector<std::string>& hashes);  ///< deleted scenarios of the list
  void rename(const std::string& hash, const std::string& name);
  void tag(const std::vector<std::string>& add, const std::vector<std::string>& remove);
  void save_as(const std::string& path);  ///< a copy; this list stays open
  void create_index(const std::string& name, const std::string& descriptor,
                    const std::vector<double>& edges);
  void drop_index(const std::string& name);
  /// Like make_deduplicate(); returns the number of removed scenarios.
  std::size_t deduplicate(const std::vector<std::pair<std::string, double>>& min_differences);
  /// Replaces the current scenario by an edited one, which becomes current, and selected if the
  /// other was. It stays so when the edit is undone and redone, whatever its row is.
  void edit_current(const Scenario& scenario);
  void undo();
  void redo();
  /// Runs a command on this list, after which the scenario `new_current` is current, if not empty.
  /// Throws Error (Usage) if it is disabled.
  void run(ListCommandPtr command, const std::string& new_current = "");
  /// Updates the view after a command of another document changed this list.
  void accept_changes();

 private:
  struct stat file_on_disk() const;
  std::string write_error() const;  ///< why the file cannot be written
  std::string path_error() const;   ///< why the file is no longer at its path
  std::string no_deletions_reason() const;
  void require_enabled(ListAction action) const;
  void show(ListView view);
  void deselect_hidden();
  void find_sort_values();
  ListRow make_row(const ScenarioList::Entry& entry);
  void fail(const std::string& message);
  void keep_current_valid(const std::optional<std::size_t>& old_position);
  void follow_current(const std::map<std::string, std::string>& contents);
  void reopen();
  ListSelection selection() const;
  void transfer(ListDocument& target, bool move);
  void notify(Change change) const {
    if (observer_) observer_(change);
  }
  std::string job_key() const { return "view of " + path_; }

  std::string path_;
  Jobs* jobs_;
  std::function<void(Change)> observer_;
  struct stat file_ = {};             ///< at the last check
  struct stat unreadable_file_ = {};  ///< replaced it and could not be read
  std::shared_ptr<ScenarioList> list_;
  CommandHistory history_;
  ListViewRequest request_;
  std::string filter_text_, filter_error_, notice_;
  ListView view_;
  ListLines lines_;
  std::set<std::string> collapsed_;  ///< titles of groups
  std::string current_;
  std::map<std::string, std::string> edited_to_, edited_from_;  ///< hashes
  std::string pending_current_;    ///< becomes current with the view being computed
  std::vector<char> is_selected_;  ///< for each index of the view
  std::size_t selected_ = 0;
  std::optional<std::size_t> anchor_;  ///< where a range selection starts
  std::map<std::string, ListRow> rows_;
  std::vector<ValueKey> sort_keys_;
  std::shared_ptr<const ListField> sort_field_;  ///< null unless sorted by a result
  std::string sort_unit_ = "-";
};

}  // namespace slalom
