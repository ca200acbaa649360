#include "choice.h"

#include <slalom/core/error.h>

#include <iostream>

namespace slalom {
namespace {

struct TransferArguments {
  ChoiceArguments choice;
  std::string output;
  bool plan = false, all = false, file = false;
};

/// What the new list notes about where it came from.
std::string origin_of(const ChoiceArguments& choice) {
  std::string text = "from " + choice.list.list;
  if (!choice.where.empty()) text += " where " + choice.where;
  if (!choice.ids.empty()) text += " ids " + choice.ids;
  if (!choice.order_by.empty()) text += " order by " + choice.order_by;
  if (choice.limit >= 0) text += " limit " + std::to_string(choice.limit);
  return text;
}

void select(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  const ListSelection selection = choose(list, arguments.choice);
  if (arguments.plan) {
    std::cout << list.query_plan(selection);
    return;
  }
  if (arguments.output.empty()) {
    list.for_each(selection, [&](const ScenarioList::Entry& entry) {
      print_entry(entry, arguments.choice.list.json);
      return true;
    });
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, selection, target)->execute();
    for (const ListIndex& index : list.indexes()) target.create_index(index);
    target.set_note("origin", origin_of(arguments.choice));
  });
  tell_size(ScenarioList::open(arguments.output), arguments.choice.quiet);
}

void copy(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  const ListSelection selection = choose(list, arguments.choice);
  ScenarioList target = open_or_create(arguments.output);
  make_copy_scenarios(list, selection, target)->execute();
  tell_size(target, arguments.choice.quiet);
}

void move(const TransferArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  const ListSelection selection = choose(list, arguments.choice);
  ScenarioList target = open_or_create(arguments.output);
  make_move_scenarios(list, selection, target)->execute();
  tell_size(list, arguments.choice.quiet);
  tell_size(target, arguments.choice.quiet);
}

void remove(const TransferArguments& arguments) {
  const ChoiceArguments& choice = arguments.choice;
  if (arguments.file) {
    if (choice.names_some() || arguments.all)
      throw usage_error("delete --file", "removes the whole file", "no --where, --ids or --all");
    ScenarioList::remove_file(choice.list.list);
    return;
  }
  if (choice.names_some() == arguments.all)
    throw usage_error("delete " + choice.list.list, "which scenarios?",
                      "--where EXPRESSION, --ids A,B, or --all");
  ScenarioList list = ScenarioList::open(choice.list.list);
  ListSelection selection = choose(list, choice);
  if (arguments.output.empty()) {
    make_delete_scenarios(list, selection)->execute();
    tell_size(list, choice.quiet);
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, {}, target)->execute();
    make_delete_scenarios(target, selection)->execute();
    for (const ListIndex& index : list.indexes()) target.create_index(index);
  });
  tell_size(ScenarioList::open(arguments.output), choice.quiet);
}

CLI::Option* add_output(CLI::App& verb, TransferArguments& arguments, const std::string& help) {
  return verb.add_option("-o,--output", arguments.output, help);
}

}  // namespace

void add_select_verbs(CLI::App& app) {
  static TransferArguments selected, copied, moved, deleted;
  CLI::App* verb = add_choice_verb(app, "select", "List scenarios, or write them to a new list",
                                   selected.choice);
  add_order_options(*verb, selected.choice);
  add_output(*verb, selected, "The list to write; without it they are printed");
  verb->add_flag("--json", selected.choice.list.json, "One JSON object per scenario");
  verb->add_flag("--plan", selected.plan, "Print how the list is searched, and with which indexes");
  verb->callback([] { select(selected); });

  verb = add_choice_verb(app, "copy", "Append scenarios to another list", copied.choice);
  add_order_options(*verb, copied.choice);
  add_output(*verb, copied, "The other list; made when it is not there")->required();
  verb->callback([] { copy(copied); });

  verb = add_choice_verb(app, "move", "Append scenarios to another list and remove them here",
                         moved.choice);
  add_order_options(*verb, moved.choice);
  add_output(*verb, moved, "The other list; made when it is not there")->required();
  verb->callback([] { move(moved); });

  verb = add_choice_verb(app, "delete", "Remove scenarios from a list", deleted.choice);
  add_output(*verb, deleted, "Write the rest there, and leave the list as it is");
  verb->add_flag("--all", deleted.all, "All of them; the list stays, empty");
  verb->add_flag("--file", deleted.file, "The list itself");
  verb->callback([] { remove(deleted); });
}

}  // namespace slalom
