// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <iostream>

namespace slalom {
namespace {

struct SetArguments {
  FilterArguments filter;
  std::vector<std::string> lists;
  std::string output, by, development, held_out;
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
  print_size(ScenarioList::open(arguments.output), arguments.filter.quiet);
}

void deduplicate(const SetArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const auto differences = parse_min_differences(arguments.by, "--by");
  std::vector<std::string> ids;
  for (const auto& [id, difference] : differences) ids.push_back(id);
  const DescriptorView view =
      describe_all(list, arguments.filter.list, ids, arguments.filter.quiet);
  if (arguments.output.empty()) {
    make_deduplicate(list, view, differences)->execute();
    print_size(list, arguments.filter.quiet);
    return;
  }
  ScenarioList::write(arguments.output, [&](ScenarioList& target) {
    make_copy_scenarios(list, {}, target)->execute();
    make_deduplicate(target, view, differences)->execute();
  });
  print_size(ScenarioList::open(arguments.output), arguments.filter.quiet);
}

void split_list(const SetArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  if (arguments.development == arguments.held_out)
    throw usage_error("--held-out " + arguments.held_out, "same as the development list",
                      "another list");
  // Neither list is replaced unless both are written.
  ScenarioList::write(arguments.development, [&](ScenarioList& development) {
    ScenarioList::write(arguments.held_out, [&](ScenarioList& held_out) {
      make_split(list, arguments.split, development, held_out)->execute();
      for (auto [target, part] : {std::pair{&development, "development"}, {&held_out, "held out"}})
        target->set_note("origin", std::string(part) + " part of " + list.path() + ", fraction " +
                                       format_number(arguments.split.held_out) + ", seed " +
                                       std::to_string(arguments.split.seed));
    });
  });
  print_size(ScenarioList::open(arguments.development), arguments.filter.quiet);
  print_size(ScenarioList::open(arguments.held_out), arguments.filter.quiet);
}

}  // namespace

void add_lists_verbs(CLI::App& app) {
  static SetArguments created, merged, deduplicated, halves;
  CLI::App* verb = app.add_subcommand("create", "Create an empty list");
  verb->add_option("list", created.output, "The list to write (.scenarios)")->required();
  verb->callback([] { create(created); });

  verb = app.add_subcommand("merge", "Merge lists; drops duplicate contents");
  verb->add_option("lists", merged.lists, "Scenario lists (.scenarios)")->required();
  verb->add_option("-o,--output", merged.output, "The list to write")->required();
  verb->add_flag("--quiet", merged.filter.quiet, "No messages");
  verb->callback([] { merge(merged); });

  verb = add_list_verb(app, "dedupe", "Remove near-duplicate scenarios", deduplicated.filter.list);
  verb->add_option("--by", deduplicated.by,
                   "Minimum differences, such as density:0.01,confinement:0.02")
      ->required();
  verb->add_option("-o,--output", deduplicated.output,
                   "Write the remaining scenarios to this list instead of changing LIST");
  add_robot_options(*verb, deduplicated.filter.list);
  verb->add_flag("--quiet", deduplicated.filter.quiet, "No progress and no messages");
  verb->callback([] { deduplicate(deduplicated); });

  verb = add_list_verb(app, "split", "Split into a development and a held-out list",
                       halves.filter.list);
  verb->add_option("--fraction", halves.split.held_out, "Fraction that is held out")
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--seed", halves.split.seed, "Seed")->capture_default_str();
  verb->add_option("--development", halves.development, "The list to write")->required();
  verb->add_option("--held-out", halves.held_out, "The list to write")->required();
  verb->add_flag("--quiet", halves.filter.quiet, "No messages");
  verb->callback([] { split_list(halves); });
}

}  // namespace slalom
