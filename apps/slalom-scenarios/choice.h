#pragma once

#include "verbs.h"

#include <slalom/commands/describe_list.h>
#include <slalom/commands/list_command.h>

#include <string>

namespace slalom {

/// Which scenarios of a list a verb is about, as the command line says it.
struct ChoiceArguments {
  ListArguments list;
  std::string where, ids, order_by;
  long long limit = -1;
  bool quiet = false;

  bool names_some() const { return !where.empty() || !ids.empty(); }
};

/// LIST, --where, --ids and for whom descriptors are meant.
CLI::App* add_choice_verb(CLI::App& app, const std::string& name, const std::string& help,
                          ChoiceArguments& arguments);
void add_order_options(CLI::App& verb, ChoiceArguments& arguments);  ///< --order-by, --limit

DescribeOptions describe_options(const ListArguments& arguments);

/// Computes the values of these descriptors that the list lacks, and keeps them.
DescriptorView describe_all(ScenarioList& list, const ListArguments& arguments,
                            std::vector<std::string> ids, bool quiet);

/// Understands the choice; computes values that it speaks of and the list lacks.
ListSelection choose(ScenarioList& list, const ChoiceArguments& arguments);

/// The list, made when it is not there.
ScenarioList open_or_create(const std::string& path);

/// "PATH: N scenarios" on standard error, unless quiet.
void tell_size(const ScenarioList& list, bool quiet);

/// One line about a scenario on standard output.
void print_entry(const ScenarioList::Entry& entry, bool json);

}  // namespace slalom
