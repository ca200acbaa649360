#pragma once

#include <slalom/core/progress.h>
#include <slalom/io/scenario_list.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// One user action on a scenario list that can be taken back (Command).
class ListCommand {
 public:
  virtual ~ListCommand() = default;
  virtual std::string title() const = 0;  ///< for menus and messages, e.g. "Add 12 scenarios"
  virtual void execute() = 0;
  virtual void undo() = 0;  ///< the list is as before execute()
};

/// Appends scenarios; those whose content is already there are left out.
std::unique_ptr<ListCommand> make_add_scenarios(ScenarioList& list,
                                                std::vector<Scenario> scenarios);

}  // namespace slalom
