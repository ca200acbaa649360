// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/core/text.h>

namespace slalom {

RecordedCommand::RecordedCommand(std::vector<ScenarioList*> lists, std::string title, Act act,
                                 DisabledReason disabled_reason)
    : lists_(std::move(lists)),
      title_(std::move(title)),
      act_(std::move(act)),
      disabled_reason_(std::move(disabled_reason)),
      changes_(lists_.size()) {}

void RecordedCommand::execute() {
  record_from(lists_.size());
}

/// The first list is innermost, so it is committed first.
void RecordedCommand::record_from(std::size_t list) {
  if (list == 0) {
    act_();
    return;
  }
  changes_[list - 1] = lists_[list - 1]->record([&] { record_from(list - 1); });
}

void RecordedCommand::undo() {
  // Restore removed scenarios before removing added ones.
  in_all(0, [&] {
    for (std::size_t i = lists_.size(); i-- > 0;) lists_[i]->revert(changes_[i]);
  });
}

void RecordedCommand::redo() {
  in_all(0, [&] {
    for (std::size_t i = 0; i < lists_.size(); ++i) lists_[i]->apply(changes_[i]);
  });
}

void RecordedCommand::in_all(std::size_t list, const Act& act) {
  if (list == lists_.size()) {
    act();
    return;
  }
  lists_[list]->in_transaction([&] { in_all(list + 1, act); });
}

std::string scenarios_text(std::size_t count) {
  return count_text(count, "scenario");
}

}  // namespace slalom
