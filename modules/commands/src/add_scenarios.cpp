#include <slalom/commands/list_command.h>

namespace slalom {
namespace {

class AddScenarios : public ListCommand {
 public:
  AddScenarios(ScenarioList& list, std::vector<Scenario> scenarios)
      : list_(list), scenarios_(std::move(scenarios)) {}

  std::string title() const override {
    return "Add " + std::to_string(scenarios_.size()) + " scenarios";
  }

  void execute() override { added_ = list_.add_all(scenarios_); }

  void undo() override {
    for (const std::string& hash : added_) list_.remove(hash);
    added_.clear();
  }

 private:
  ScenarioList& list_;
  std::vector<Scenario> scenarios_;
  std::vector<std::string> added_;  ///< hashes of those that were not there before
};

}  // namespace

std::unique_ptr<ListCommand> make_add_scenarios(ScenarioList& list,
                                                std::vector<Scenario> scenarios) {
  return std::make_unique<AddScenarios>(list, std::move(scenarios));
}

}  // namespace slalom
