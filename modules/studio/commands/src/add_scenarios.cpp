// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

namespace slalom {

ListCommandPtr make_add_scenarios(ScenarioList& list, std::vector<Scenario> scenarios,
                                  std::vector<ScenarioOrigin> origins) {
  const std::string title = "Add " + scenarios_text(scenarios.size());
  const bool none = scenarios.empty();
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&list}, title,
      [&list, scenarios = std::move(scenarios), origins = std::move(origins)] {
        list.add_all(scenarios, origins);
      },
      [none] { return std::string(none ? "no scenarios to add" : ""); });
}

}  // namespace slalom
