// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/studio/list_document.h>

#include <filesystem>

namespace slalom {
namespace {

/// A command that keeps its lists open after their documents are closed.
class ListOwningCommand : public ListCommand {
 public:
  ListOwningCommand(std::vector<std::shared_ptr<ScenarioList>> lists, ListCommandPtr command)
      : lists_(std::move(lists)), command_(std::move(command)) {}

  std::string title() const override { return command_->title(); }
  std::string disabled_reason() const override { return command_->disabled_reason(); }
  void execute() override { command_->execute(); }
  void undo() override { command_->undo(); }
  void redo() override { command_->redo(); }

 private:
  std::vector<std::shared_ptr<ScenarioList>> lists_;
  ListCommandPtr command_;  ///< destroyed before the lists
};

}  // namespace

std::string ListDocument::disabled_reason(ListAction action) const {
  const auto unless = [](bool enabled, const char* reason) {
    return std::string(enabled ? "" : reason);
  };
  if (action == ListAction::SaveAs) return "";
  const std::string selection = unless(selected_ > 0, "nothing is selected");
  if (action == ListAction::CopyTo) return selection;  // this list is only read
  // An undone command may have written to another list.
  const bool history = action == ListAction::Undo || action == ListAction::Redo;
  const std::string file = history ? path_error() : write_error();
  if (!file.empty()) return file;
  switch (action) {
    case ListAction::Undo:
      return unless(history_.can_undo(), "there is nothing to undo");
    case ListAction::Redo:
      return unless(history_.can_redo(), "there is nothing to redo");
    case ListAction::Restore:
      return no_deletions_reason();
    case ListAction::Rename:
      return unless(!current_.empty(), "no scenario is shown");
    case ListAction::DropIndex:
      return unless(!list_->indexes().empty(), "the list has no index");
    case ListAction::Deduplicate:
    case ListAction::CreateIndex:
      return unless(view_.total > 0, "the list is empty");
    default:
      return selection;
  }
}

std::string ListDocument::no_deletions_reason() const {
  try {
    return list_->has_deletions() ? "" : "there are no deleted scenarios";
  } catch (const Error& e) {
    return reason_of(e);  // a damaged file
  }
}

void ListDocument::require_enabled(ListAction action) const {
  const std::string reason = disabled_reason(action);
  if (!reason.empty()) throw usage_error(title(), reason);
}

ListSelection ListDocument::selection() const {
  ListSelection selection;
  selection.hashes = selected();
  return selection;
}

void ListDocument::accept_changes() {
  file_ = file_on_disk();
  notice_.clear();
  refresh();
}

void ListDocument::run(ListCommandPtr command, const std::string& new_current) {
  const std::string file = write_error();
  if (!file.empty()) throw usage_error(title(), file);
  const std::string reason = command->disabled_reason();
  if (!reason.empty()) throw usage_error(title(), reason);
  history_.execute(std::move(command));
  if (!new_current.empty()) pending_current_ = new_current;
  accept_changes();
  notify(Change::Command);
}

void ListDocument::transfer(ListDocument& target, bool move) {
  require_enabled(move ? ListAction::MoveTo : ListAction::CopyTo);
  const std::string file = target.write_error();
  if (!file.empty()) throw usage_error(target.title(), file);
  auto command = move ? make_move_scenarios(*list_, selection(), *target.list_)
                      : make_copy_scenarios(*list_, selection(), *target.list_);
  history_.execute(std::make_unique<ListOwningCommand>(
      std::vector<std::shared_ptr<ScenarioList>>{list_, target.list_}, std::move(command)));
  target.accept_changes();
  if (move) accept_changes();
  notify(Change::Command);
}

void ListDocument::copy_to(ListDocument& target) {
  transfer(target, false);
}

void ListDocument::move_to(ListDocument& target) {
  transfer(target, true);
}

void ListDocument::remove_selected() {
  require_enabled(ListAction::Remove);
  run(make_delete_scenarios(*list_, selection()));
}

void ListDocument::restore(const std::vector<std::string>& hashes) {
  require_enabled(ListAction::Restore);
  run(make_restore_scenarios(*list_, hashes), hashes.empty() ? "" : hashes.front());
}

void ListDocument::rename(const std::string& hash, const std::string& name) {
  require_enabled(ListAction::Rename);
  run(make_rename_scenario(*list_, hash, name));
}

void ListDocument::tag(const std::vector<std::string>& add,
                       const std::vector<std::string>& remove) {
  require_enabled(ListAction::Tag);
  run(make_tag_scenarios(*list_, selection(), add, remove));
}

void ListDocument::save_as(const std::string& path) {
  std::error_code ignored;
  if (file_state() != FileState::Gone && std::filesystem::equivalent(path, path_, ignored))
    throw usage_error(path, "is the open list itself", "another file name");
  list_->save_as(path);
}

void ListDocument::create_index(const std::string& name, const std::string& descriptor,
                                const std::vector<double>& edges) {
  require_enabled(ListAction::CreateIndex);
  const auto keys = descriptor_view({descriptor}, request_.describe).at(descriptor);
  run(make_create_index(*list_, {name, descriptor, keys, edges}));
}

void ListDocument::drop_index(const std::string& name) {
  require_enabled(ListAction::DropIndex);
  run(make_drop_index(*list_, name));
}

std::size_t ListDocument::deduplicate(
    const std::vector<std::pair<std::string, double>>& min_differences) {
  require_enabled(ListAction::Deduplicate);
  std::vector<std::string> ids;
  for (const auto& [id, difference] : min_differences) ids.push_back(id);
  const std::size_t old_size = list_->size();
  run(make_deduplicate(*list_, descriptor_view(ids, request_.describe), min_differences));
  return old_size - list_->size();
}

void ListDocument::edit_current(const Scenario& scenario) {
  const std::string before = current_;
  const std::string& after = scenario.hash();
  const auto index = view_.index_of(before);
  ListCommandPtr command = make_edit_scenario(*list_, before, scenario);
  if (index) request_.held = {after, *index};
  run(std::move(command), after);
  edited_to_[before] = after;
  edited_from_[after] = before;
}

/// To the content that the current scenario had before an edit, or has after it, where its own is
/// no longer in the list.
void ListDocument::follow_current(const std::map<std::string, std::string>& contents) {
  ListSelection current;
  current.hashes = {current_};
  const auto found = contents.find(current_);
  if (found != contents.end() && list_->count(current) == 0) pending_current_ = found->second;
}

void ListDocument::undo() {
  require_enabled(ListAction::Undo);
  history_.undo();
  follow_current(edited_from_);
  accept_changes();
}

void ListDocument::redo() {
  require_enabled(ListAction::Redo);
  history_.redo();
  follow_current(edited_to_);
  accept_changes();
}

}  // namespace slalom
