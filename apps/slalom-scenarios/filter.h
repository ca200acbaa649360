// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verbs.h"

#include <slalom/commands/list_command.h>
#include <slalom/commands/select_list.h>

#include <string>

namespace slalom {

/// Command-line arguments that select scenarios of a list.
struct FilterArguments {
  ListArguments list;
  SelectionRequest selection;
  bool quiet = false;
};

/// Adds a verb with LIST, --where, --ids and the parameters of descriptors.
CLI::App* add_filter_verb(CLI::App& app, const std::string& name, const std::string& help,
                          FilterArguments& arguments);
void add_order_options(CLI::App& verb, FilterArguments& arguments);  ///< --order-by, --limit

/// Computes the missing values of these descriptors and stores them in the list.
DescriptorView describe_all(ScenarioList& list, const ListArguments& arguments,
                            const std::vector<std::string>& ids, bool quiet);

/// The selected scenarios; warns if there are none.
ListSelection select_scenarios(ScenarioList& list, const FilterArguments& arguments);

/// The scenario of the list with the given id or name.
Scenario load_scenario(const ListArguments& arguments);

/// Opens the list; creates it if it does not exist.
ScenarioList open_or_create(const std::string& path);

/// Prints "PATH: N scenarios" to standard error, unless quiet.
void print_size(const ScenarioList& list, bool quiet);

/// Prints one line about a scenario to standard output.
void print_entry(const ScenarioList::Entry& entry, bool json);

}  // namespace slalom
