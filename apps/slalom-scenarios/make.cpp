// SPDX-License-Identifier: BSD-3-Clause
#include "generate.h"
#include "make_list.h"
#include "verbs.h"

#include <slalom/commands/list_command.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <iostream>

namespace slalom {

void write_scenarios(const std::string& path, std::vector<Scenario> scenarios,
                     const std::vector<std::pair<std::string, std::string>>& notes, bool quiet) {
  std::size_t size = 0;
  ScenarioList::write(path, [&](ScenarioList& list) {
    make_add_scenarios(list, std::move(scenarios))->execute();
    for (const auto& [key, text] : notes) list.set_note(key, text);
    size = list.size();
  });
  if (!quiet) std::cerr << path << ": " << count_text(size, "scenario") << "\n";
}

void add_creation_verbs(CLI::App& app) {
  add_generate_verb(app);
  add_import_verb(app);
}

}  // namespace slalom
