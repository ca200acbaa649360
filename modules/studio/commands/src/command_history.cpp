// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/list_command.h>

#include <stdexcept>

namespace slalom {

void CommandHistory::execute(std::unique_ptr<ListCommand> command) {
  command->execute();
  commands_.resize(done_);
  commands_.push_back(std::move(command));
  if (commands_.size() > max_length_) commands_.pop_front();
  done_ = commands_.size();
}

std::string CommandHistory::undo_title() const {
  return can_undo() ? commands_[done_ - 1]->title() : "";
}

std::string CommandHistory::redo_title() const {
  return can_redo() ? commands_[done_]->title() : "";
}

void CommandHistory::undo() {
  if (!can_undo()) throw std::logic_error("nothing to undo");
  commands_[done_ - 1]->undo();
  --done_;
}

void CommandHistory::redo() {
  if (!can_redo()) throw std::logic_error("nothing to redo");
  commands_[done_]->redo();
  ++done_;
}

}  // namespace slalom
