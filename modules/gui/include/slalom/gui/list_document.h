#pragma once

#include <slalom/commands/list_command.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/gui/list_lines.h>
#include <slalom/gui/list_view.h>

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

/// What a row of a list shows besides the picture.
struct ListRow {
  ScenarioList::Entry entry;
  std::optional<Value> value;  ///< by which the list is sorted; none where never computed
};

/// What can be done with an open list.
enum class ListAction {
  Undo,
  Redo,
  CopyTo,
  MoveTo,
  Remove,
  Rename,
  Tag,
  SaveAs,
  CreateIndex,
  DropIndex,
  Deduplicate
};

/// An open scenario list as a window shows it: what is visible of it, what is selected, which
/// scenario is the current one, and what was done to it. Knows no window. Belongs to one thread.
class ListDocument {
 public:
  /// Opens the list; nothing is shown before refresh(). Views of long lists are computed by `jobs`
  /// where given. Throws as ScenarioList::open() does.
  explicit ListDocument(const std::string& path, Jobs* jobs = nullptr);
  ~ListDocument();
  ListDocument(const ListDocument&) = delete;
  ListDocument& operator=(const ListDocument&) = delete;

  const std::string& path() const { return path_; }
  std::string title() const;  ///< the file's name
  ScenarioList& list() { return *list_; }
  CommandHistory& history() { return history_; }

  // Called when something other than the caller expects may have changed.
  std::function<void(const std::string& hash)> on_current;  ///< empty: none
  std::function<void()> on_selection;
  std::function<void()> on_view;  ///< rows, groups or messages

  // What is shown. Each setter computes the view anew.
  const ListViewRequest& request() const { return request_; }
  /// What makes no sense is told by filter_error(), and the view stays as it is.
  void set_filter(const std::string& text);
  void set_sort(const std::string& field, bool descending);
  const std::string& sort_unit() const { return sort_unit_; }  ///< "-" where it has none
  void set_group_by(const std::string& index);
  /// For whom values are kept that filters and sorting speak of.
  void set_describe_options(const DescribeOptions& options);
  const std::string& filter_text() const { return filter_text_; }  ///< as last set
  const std::string& filter_error() const { return filter_error_; }
  const std::string& notice() const { return notice_; }  ///< what happened to the file, if anything
  bool is_computing() const;                             ///< a view is on its way
  void refresh();                                        ///< after the list was changed
  /// Keeps computed values of one scenario; nothing where the list does not have it.
  void keep_values(const std::string& hash, const std::vector<GeneratedValue>& values);
  const ListView& view() const { return view_; }
  const ListLines& lines() const { return lines_; }
  void toggle_group(std::size_t group);
  /// Read when first asked for; kept for some thousand rows. None when it is gone.
  const ListRow* row(const std::string& hash);
  std::vector<ListIndex> indexes() const { return list_->indexes(); }

  // Current and selected scenarios, by their place in the view.
  const std::string& current() const { return current_; }
  /// Ignored when it is neither shown nor in the view that is on its way.
  void set_current(const std::string& hash);
  bool is_selected(std::size_t place) const { return marks_[place] != 0; }
  std::size_t selected_count() const { return selected_; }
  std::vector<std::string> selected() const;  ///< hashes, as shown
  void select_only(std::size_t place);        ///< a click
  void toggle(std::size_t place);             ///< with Ctrl
  void select_to(std::size_t place);          ///< with Shift: from the last click to here
  void select_all();
  void select_none();
  void select(const std::vector<std::string>& hashes);  ///< those of them that are shown

  /// What another program did to the file since it was last looked at.
  enum class FileState { Same, Changed, Replaced, Gone };
  FileState file_state() const;
  /// Looks, shows what changed and says so in notice(). True when something was done.
  bool follow_file();

  // Actions. `obstacle` says why one cannot be done as things are, empty when it can; they throw
  // Error then, and what the list throws.
  std::string obstacle(ListAction action) const;
  void copy_to(ListDocument& target);
  void move_to(ListDocument& target);
  void remove_selected();
  void rename(const std::string& hash, const std::string& name);
  void tag(const std::vector<std::string>& add, const std::vector<std::string>& remove);
  void save_as(const std::string& path);  ///< a copy; this list stays the open one
  void create_index(const std::string& name, const std::string& descriptor,
                    const std::vector<double>& edges);
  void drop_index(const std::string& name);
  /// As make_deduplicate(); returns how many were left out.
  std::size_t deduplicate(const std::vector<std::pair<std::string, double>>& least_differences);
  void undo();
  void redo();
  /// Any command on this list; says the same as obstacle() where it cannot be run.
  void run(ListCommandPtr command);
  /// Shows what a command of another document has done to this list.
  void accept_changes();

 private:
  struct stat file_on_disk() const;
  std::string file_obstacle() const;  ///< of writing
  std::string path_obstacle() const;  ///< this file is no longer at its path
  void expect_possible(ListAction action) const;
  void show(ListView view);
  void fail(const std::string& message);
  void set_marks(const std::vector<std::string>& hashes);
  void move_current(const std::optional<std::size_t>& old_place);
  void reopen();
  ListSelection selection() const;
  void transfer(ListDocument& target, bool move);
  void tell_selection();
  std::string job_key() const { return "view of " + path_; }

  std::string path_;
  Jobs* jobs_;
  struct stat file_ = {};     ///< as it was last looked at
  struct stat refused_ = {};  ///< what took its place and could not be read
  std::shared_ptr<ScenarioList> list_;
  CommandHistory history_;
  ListViewRequest request_;
  std::string filter_text_, filter_error_, notice_;
  ListView view_;
  ListLines lines_;
  std::set<std::string> collapsed_;  ///< titles of groups
  std::string current_;
  std::string wanted_;       ///< current once the view on its way is there
  std::vector<char> marks_;  ///< for each place, whether it is selected
  std::size_t selected_ = 0;
  std::optional<std::size_t> anchor_;  ///< from where select_to() counts
  std::map<std::string, ListRow> rows_;
  std::vector<DescriptorKey> sort_keys_;
  std::string sort_unit_ = "-";
};

}  // namespace slalom
