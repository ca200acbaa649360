#include "choice.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <iostream>

namespace slalom {
namespace {

struct SetArguments {
  ChoiceArguments choice;
  std::vector<std::string> lists;
  std::string output, by, development, held_out, add, remove, id, name;
  SplitOptions split;
};

void create(const SetArguments& arguments) {
  ScenarioList::create(arguments.output);
}

void merge(const SetArguments& arguments) {
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    std::vector<ScenarioList> lists;
    std::vector<ScenarioList*> sources;
    for (const std::string& path : arguments.lists) lists.push_back(ScenarioList::open(path));
    for (ScenarioList& list : lists) sources.push_back(&list);
    make_merge_lists(sources, target)->execute();
    target.set_note("origin", "merged: " + join(arguments.lists, " "));
  });
  tell_size(ScenarioList::open(arguments.output), arguments.choice.quiet);
}

/// "density:0.01,confinement:0.02"
std::vector<std::pair<std::string, double>> differences_of(const std::string& text) {
  std::vector<std::pair<std::string, double>> differences;
  for (const std::string& part : split(text, ',')) {
    const std::vector<std::string> pair = split(part, ':');
    double difference = 0;
    if (pair.size() != 2 || !parse_number(pair[1], difference) || !(difference > 0))
      throw usage_error("--by " + text, "'" + part + "' is no least difference",
                        "DESCRIPTOR:NUMBER, the number > 0");
    descriptor(pair[0]);
    differences.emplace_back(pair[0], difference);
  }
  return differences;
}

void deduplicate(const SetArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  const auto differences = differences_of(arguments.by);
  std::vector<std::string> ids;
  for (const auto& [id, difference] : differences) ids.push_back(id);
  const DescriptorView view =
      describe_all(list, arguments.choice.list, ids, arguments.choice.quiet);
  if (arguments.output.empty()) {
    make_deduplicate(list, view, differences)->execute();
    tell_size(list, arguments.choice.quiet);
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, {}, target)->execute();
    make_deduplicate(target, view, differences)->execute();
  });
  tell_size(ScenarioList::open(arguments.output), arguments.choice.quiet);
}

void split_list(const SetArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  if (arguments.development == arguments.held_out)
    throw usage_error("--held-out " + arguments.held_out, "is the development list",
                      "another list");
  // The development set must not take its place without the other.
  ScenarioList::write(arguments.development, [&](ScenarioList& development) {
    ScenarioList::write(arguments.held_out, [&](ScenarioList& held_out) {
      make_split(list, arguments.split, development, held_out)->execute();
      for (auto [target, half] : {std::pair{&development, "development"}, {&held_out, "held out"}})
        target->set_note("origin", std::string(half) + " half of " + list.path() + ", share " +
                                       format_number(arguments.split.held_out) + ", seed " +
                                       std::to_string(arguments.split.seed));
    });
  });
  tell_size(ScenarioList::open(arguments.development), arguments.choice.quiet);
  tell_size(ScenarioList::open(arguments.held_out), arguments.choice.quiet);
}

void tag(const SetArguments& arguments) {
  if (arguments.add.empty() && arguments.remove.empty())
    throw usage_error("tag", "which tags?", "--add A,B or --remove C");
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  const ListSelection selection = choose(list, arguments.choice);
  make_tag_scenarios(list, selection, split(arguments.add, ','), split(arguments.remove, ','))
      ->execute();
}

void rename(const SetArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.choice.list.list);
  make_rename_scenario(list, list.find_entry(arguments.id).hash, arguments.name)->execute();
}

void add_set_verbs(CLI::App& app) {
  static SetArguments created, merged, deduplicated, halves;
  CLI::App* verb = app.add_subcommand("create", "Make an empty list");
  verb->add_option("list", created.output, "The list to write (.scenarios)")->required();
  verb->callback([] { create(created); });

  verb = app.add_subcommand("merge", "Join lists; equal contents count once");
  verb->add_option("lists", merged.lists, "Scenario lists (.scenarios)")->required();
  verb->add_option("-o,--output", merged.output, "The list to write")->required();
  verb->add_flag("--quiet", merged.choice.quiet, "No messages");
  verb->callback([] { merge(merged); });

  verb = add_list_verb(app, "dedupe", "Leave out scenarios that are too much alike",
                       deduplicated.choice.list);
  verb->add_option("--by", deduplicated.by,
                   "Least differences, such as density:0.01,confinement:0.02")
      ->required();
  verb->add_option("-o,--output", deduplicated.output,
                   "Write the rest there, and leave the list as it is");
  add_robot_options(*verb, deduplicated.choice.list);
  verb->add_flag("--quiet", deduplicated.choice.quiet, "No progress and no messages");
  verb->callback([] { deduplicate(deduplicated); });

  verb = add_list_verb(app, "split", "Write development and held-out sets", halves.choice.list);
  verb->add_option("--share", halves.split.held_out, "Share that is held out")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--seed", halves.split.seed, "Seed")->capture_default_str();
  verb->add_option("--development", halves.development, "The list to write")->required();
  verb->add_option("--held-out", halves.held_out, "The list to write")->required();
  verb->add_flag("--quiet", halves.choice.quiet, "No messages");
  verb->callback([] { split_list(halves); });
}

}  // namespace

void add_lists_verbs(CLI::App& app) {
  add_set_verbs(app);
  static SetArguments tagged, renamed;
  CLI::App* verb = add_choice_verb(app, "tag", "Add and remove tags", tagged.choice);
  verb->add_option("--add", tagged.add, "Tags, comma separated");
  verb->add_option("--remove", tagged.remove, "Tags, comma separated");
  verb->callback([] { tag(tagged); });

  verb = add_list_verb(app, "rename", "Give a scenario another name", renamed.choice.list);
  verb->add_option("--id", renamed.id, "Id, beginning of it, or name")->required();
  verb->add_option("--name", renamed.name, "The new name")->required();
  verb->callback([] { rename(renamed); });
}

}  // namespace slalom
