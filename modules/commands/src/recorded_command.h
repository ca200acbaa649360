#pragma once

#include <slalom/commands/list_command.h>

#include <functional>

namespace slalom {

/// A command that is an edit of some lists. What the edit changes is noted, and taken back from
/// that.
class RecordedCommand : public ListCommand {
 public:
  using Act = std::function<void()>;
  using Obstacle = std::function<std::string()>;

  /// `lists` in the order in which they are made to last: those that gain before those that lose.
  RecordedCommand(std::vector<ScenarioList*> lists, std::string title, Act act,
                  Obstacle obstacle = nullptr);

  std::string title() const override { return title_; }
  std::string obstacle() const override { return obstacle_ ? obstacle_() : ""; }
  void execute() override;
  void undo() override;
  void redo() override;

 private:
  void record_from(std::size_t list);
  void in_all(std::size_t list, const Act& act);

  std::vector<ScenarioList*> lists_;
  std::string title_;
  Act act_;
  Obstacle obstacle_;
  std::vector<ListChange> changes_;
};

/// "12 scenarios", "1 scenario"
std::string scenarios_text(std::size_t count);

}  // namespace slalom
