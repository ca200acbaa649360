// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/list_command.h>

#include <functional>

namespace slalom {

/// A command that edits lists. The changes are recorded, and undo and redo apply the recorded
/// changes.
class RecordedCommand : public ListCommand {
 public:
  using Act = std::function<void()>;
  using DisabledReason = std::function<std::string()>;

  /// `lists` in commit order: lists that gain scenarios before lists that lose them.
  RecordedCommand(std::vector<ScenarioList*> lists, std::string title, Act act,
                  DisabledReason disabled_reason = nullptr);

  std::string title() const override { return title_; }
  std::string disabled_reason() const override {
    return disabled_reason_ ? disabled_reason_() : "";
  }
  void execute() override;
  void undo() override;
  void redo() override;

 private:
  void record_from(std::size_t list);
  void in_all(std::size_t list, const Act& act);

  std::vector<ScenarioList*> lists_;
  std::string title_;
  Act act_;
  DisabledReason disabled_reason_;
  std::vector<ListChange> changes_;
};

/// "12 scenarios", "1 scenario"
std::string scenarios_text(std::size_t count);

}  // namespace slalom
