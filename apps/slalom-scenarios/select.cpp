// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <iostream>

namespace slalom {
namespace {

struct TransferArguments {
  FilterArguments filter;
  std::string output;
  bool plan = false, all = false, file = false;
};

void select(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const ListSelection selection = select_scenarios(list, arguments.filter);
  if (arguments.plan) {
    std::cout << list.query_plan(selection);
    return;
  }
  if (arguments.output.empty()) {
    list.for_each(selection, [&](const ScenarioList::Entry& entry) {
      print_entry(entry, arguments.filter.list.json);
      return true;
    });
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, selection, target)->execute();
    for (const ListIndex& index : list.indexes()) target.create_index(index);
    target.set_note("origin", "from " + list.path() + origin_text(arguments.filter.selection));
  });
  print_size(ScenarioList::open(arguments.output), arguments.filter.quiet);
}

void copy(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const ListSelection selection = select_scenarios(list, arguments.filter);
  ScenarioList target = open_or_create(arguments.output);
  make_copy_scenarios(list, selection, target)->execute();
  print_size(target, arguments.filter.quiet);
}

void move(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const ListSelection selection = select_scenarios(list, arguments.filter);
  ScenarioList target = open_or_create(arguments.output);
  make_move_scenarios(list, selection, target)->execute();
  print_size(list, arguments.filter.quiet);
  print_size(target, arguments.filter.quiet);
}

void remove(const TransferArguments& arguments) {
  const FilterArguments& filter = arguments.filter;
  if (arguments.file) {
    if (filter.selection.has_condition() || arguments.all)
      throw usage_error("delete --file", "deletes the file", "no --where, --ids or --all");
    ScenarioList::remove_file(filter.list.list);
    return;
  }
  if (filter.selection.has_condition() == arguments.all)
    throw usage_error("delete " + filter.list.list, "no scenarios selected",
                      "--where EXPRESSION, --ids A,B, or --all");
  ScenarioList list = ScenarioList::open(filter.list.list);
  ListSelection selection = select_scenarios(list, filter);
  if (arguments.output.empty()) {
    make_delete_scenarios(list, selection)->execute();
    print_size(list, filter.quiet);
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, {}, target)->execute();
    make_delete_scenarios(target, selection)->execute();
    for (const ListIndex& index : list.indexes()) target.create_index(index);
  });
  print_size(ScenarioList::open(arguments.output), filter.quiet);
}

struct RestoreArguments {
  FilterArguments filter;
  std::vector<std::string> scenarios;
  bool all = false;
};

std::vector<ScenarioList::Entry> restorable(const ScenarioList& list) {
  std::vector<ScenarioList::Entry> entries;
  for (const auto& deletion : list.deletions())
    entries.insert(entries.end(), deletion.begin(), deletion.end());
  return entries;
}

/// The latest deleted scenario with this name, or the one with this id or prefix of it.
const ScenarioList::Entry& find_deleted(const std::vector<ScenarioList::Entry>& entries,
                                        const std::string& id_or_name, const std::string& path) {
  std::vector<std::string> names;
  std::vector<const ScenarioList::Entry*> matches;
  for (const ScenarioList::Entry& entry : entries) {
    if (entry.name == id_or_name || entry.hash == id_or_name) return entry;
    names.push_back(entry.name);
    if (starts_with(entry.hash, id_or_name)) matches.push_back(&entry);
  }
  if (matches.size() == 1) return *matches.front();
  if (matches.size() > 1)
    throw usage_error(path, "ambiguous id '" + id_or_name + "'", "more digits");
  throw usage_error(
      path, "unknown deleted scenario '" + id_or_name + "'",
      expected_name(id_or_name, names, "an id or a name listed by `slalom-scenarios restore`"));
}

void restore(const RestoreArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const std::vector<ScenarioList::Entry> entries = restorable(list);
  std::vector<std::string> hashes;
  for (const std::string& scenario : arguments.scenarios)
    hashes.push_back(find_deleted(entries, scenario, list.path()).hash);
  for (const ScenarioList::Entry& entry : entries) {
    if (arguments.all) hashes.push_back(entry.hash);
    if (!arguments.all && arguments.scenarios.empty())
      print_entry(entry, arguments.filter.list.json);
  }
  if (!hashes.empty()) make_restore_scenarios(list, hashes)->execute();
  if (arguments.all || !hashes.empty()) print_size(list, arguments.filter.quiet);
}

void add_restore_verb(CLI::App& app) {
  static RestoreArguments arguments;
  CLI::App* verb = add_list_verb(app, "restore", "List or bring back deleted scenarios of a list",
                                 arguments.filter.list);
  CLI::Option* scenarios =
      verb->add_option("scenarios", arguments.scenarios,
                       "Deleted scenarios: ids, prefixes of ids, or names (default: list them, the "
                       "latest deletion first)");
  CLI::Option* all = verb->add_flag("--all", arguments.all, "Restore all")->excludes(scenarios);
  verb->add_flag("--json", arguments.filter.list.json, "List one JSON object per scenario")
      ->excludes(scenarios)
      ->excludes(all);
  verb->add_flag("--quiet", arguments.filter.quiet, "No messages");
  verb->callback([] { restore(arguments); });
}

CLI::Option* add_output(CLI::App& verb, TransferArguments& arguments, const std::string& help) {
  return verb.add_option("-o,--output", arguments.output, help);
}

}  // namespace

void add_select_verbs(CLI::App& app) {
  static TransferArguments selected, copied, moved, deleted;
  CLI::App* verb = add_filter_verb(app, "select", "List scenarios, or write them to a new list",
                                   selected.filter);
  add_order_options(*verb, selected.filter);
  add_output(*verb, selected, "The list to write (default: print the scenarios)");
  verb->add_flag("--json", selected.filter.list.json, "One JSON object per scenario");
  verb->add_flag("--plan", selected.plan, "Print the query plan, with the indexes used");
  verb->callback([] { select(selected); });

  verb = add_filter_verb(app, "copy", "Append scenarios to another list", copied.filter);
  add_order_options(*verb, copied.filter);
  add_output(*verb, copied, "The other list; created if it does not exist")->required();
  verb->callback([] { copy(copied); });

  verb = add_filter_verb(app, "move", "Append scenarios to another list and remove them here",
                         moved.filter);
  add_order_options(*verb, moved.filter);
  add_output(*verb, moved, "The other list; created if it does not exist")->required();
  verb->callback([] { move(moved); });

  verb = add_filter_verb(app, "delete", "Remove scenarios from a list", deleted.filter);
  add_output(*verb, deleted, "Write the remaining scenarios to this list instead of changing LIST");
  verb->add_flag("--all", deleted.all, "Delete all scenarios; keeps the empty list");
  verb->add_flag("--file", deleted.file, "Delete the list file");
  verb->callback([] { remove(deleted); });

  add_restore_verb(app);
}

}  // namespace slalom
