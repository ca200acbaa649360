#include <slalom/core/error.h>
#include <slalom/gui/list_document.h>

#include <filesystem>

namespace slalom {
namespace {

/// A command that keeps the lists which it speaks of open, whatever becomes of their documents.
class HoldingCommand : public ListCommand {
 public:
  HoldingCommand(std::vector<std::shared_ptr<ScenarioList>> lists, ListCommandPtr command)
      : lists_(std::move(lists)), command_(std::move(command)) {}

  std::string title() const override { return command_->title(); }
  std::string obstacle() const override { return command_->obstacle(); }
  void execute() override { command_->execute(); }
  void undo() override { command_->undo(); }
  void redo() override { command_->redo(); }

 private:
  std::vector<std::shared_ptr<ScenarioList>> lists_;
  ListCommandPtr command_;  ///< goes first
};

}  // namespace

std::string ListDocument::obstacle(ListAction action) const {
  const auto unless = [](bool possible, const char* reason) {
    return std::string(possible ? "" : reason);
  };
  if (action == ListAction::SaveAs) return "";
  const std::string selection = unless(selected_ > 0, "nothing is selected");
  if (action == ListAction::CopyTo) return selection;  // this list is only read
  // What is taken back may lie in another list.
  const bool history = action == ListAction::Undo || action == ListAction::Redo;
  const std::string file = history ? path_obstacle() : file_obstacle();
  if (!file.empty()) return file;
  switch (action) {
    case ListAction::Undo:
      return unless(history_.can_undo(), "nothing was done yet");
    case ListAction::Redo:
      return unless(history_.can_redo(), "nothing was taken back");
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

void ListDocument::expect_possible(ListAction action) const {
  const std::string reason = obstacle(action);
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

void ListDocument::run(ListCommandPtr command) {
  const std::string file = file_obstacle();
  if (!file.empty()) throw usage_error(title(), file);
  const std::string reason = command->obstacle();
  if (!reason.empty()) throw usage_error(title(), reason);
  history_.execute(std::move(command));
  accept_changes();
}

void ListDocument::transfer(ListDocument& target, bool move) {
  expect_possible(move ? ListAction::MoveTo : ListAction::CopyTo);
  const std::string file = target.file_obstacle();
  if (!file.empty()) throw usage_error(target.title(), file);
  auto command = move ? make_move_scenarios(*list_, selection(), *target.list_)
                      : make_copy_scenarios(*list_, selection(), *target.list_);
  history_.execute(std::make_unique<HoldingCommand>(
      std::vector<std::shared_ptr<ScenarioList>>{list_, target.list_}, std::move(command)));
  target.accept_changes();
  if (move) accept_changes();
}

void ListDocument::copy_to(ListDocument& target) {
  transfer(target, false);
}

void ListDocument::move_to(ListDocument& target) {
  transfer(target, true);
}

void ListDocument::remove_selected() {
  expect_possible(ListAction::Remove);
  run(make_delete_scenarios(*list_, selection()));
}

void ListDocument::rename(const std::string& hash, const std::string& name) {
  expect_possible(ListAction::Rename);
  run(make_rename_scenario(*list_, hash, name));
}

void ListDocument::tag(const std::vector<std::string>& add,
                       const std::vector<std::string>& remove) {
  expect_possible(ListAction::Tag);
  run(make_tag_scenarios(*list_, selection(), add, remove));
}

void ListDocument::save_as(const std::string& path) {
  std::error_code ignored;
  if (file_state() != FileState::Gone && std::filesystem::equivalent(path, path_, ignored))
    throw usage_error(path, "is the open list itself", "another name");
  list_->save_as(path);
}

void ListDocument::create_index(const std::string& name, const std::string& descriptor,
                                const std::vector<double>& edges) {
  expect_possible(ListAction::CreateIndex);
  const auto keys = descriptor_view({descriptor}, request_.describe).at(descriptor);
  run(make_create_index(*list_, {name, descriptor, keys, edges}));
}

void ListDocument::drop_index(const std::string& name) {
  expect_possible(ListAction::DropIndex);
  run(make_drop_index(*list_, name));
}

std::size_t ListDocument::deduplicate(
    const std::vector<std::pair<std::string, double>>& least_differences) {
  expect_possible(ListAction::Deduplicate);
  std::vector<std::string> ids;
  for (const auto& [id, difference] : least_differences) ids.push_back(id);
  const std::size_t before = list_->size();
  run(make_deduplicate(*list_, descriptor_view(ids, request_.describe), least_differences));
  return before - list_->size();
}

void ListDocument::undo() {
  expect_possible(ListAction::Undo);
  history_.undo();
  accept_changes();
}

void ListDocument::redo() {
  expect_possible(ListAction::Redo);
  history_.redo();
  accept_changes();
}

}  // namespace slalom
