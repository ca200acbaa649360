// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/index_text.h>

#include <iostream>

namespace slalom {
namespace {

struct IndexArguments {
  ListArguments list;
  std::string name, descriptor, edges;
  bool quiet = false;
};

std::vector<double> edges_of(const std::string& text) {
  std::vector<double> edges;
  for (const std::string& part : split(text, ',')) {
    double edge = 0;
    if (!parse_number(part, edge))
      throw usage_error("--edges " + text, "invalid number '" + part + "'", "such as 0,0.1,0.2");
    edges.push_back(edge);
  }
  return edges;
}

void create(const IndexArguments& arguments) {
  descriptor(arguments.descriptor);  // throws for an unknown id
  ScenarioList list = ScenarioList::open(arguments.list.list);
  ListIndex index{arguments.name, arguments.descriptor, {}, edges_of(arguments.edges)};
  const SelectionVocabulary vocabulary = list.vocabulary(descriptor_ids());
  if (contains(vocabulary.numbers, index.name) || contains(vocabulary.texts, index.name))
    throw usage_error("--name " + index.name, "already the name of a field", "another name");
  const DescriptorView view =
      describe_all(list, arguments.list, {index.descriptor}, arguments.quiet);
  index.keys = view.at(index.descriptor);
  make_create_index(list, index)->execute();
}

void drop(const IndexArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.list.list);
  make_drop_index(list, arguments.name)->execute();
}

void list_indexes(const IndexArguments& arguments) {
  for (const ListIndex& index : ScenarioList::open(arguments.list.list).indexes()) {
    if (arguments.list.json) {
      std::cout << render_json(index) << "\n";
      continue;
    }
    std::vector<std::string> edges;
    for (const double edge : index.edges) edges.push_back(format_number(edge));
    std::cout << printable_line(index.name) << "  " << index.descriptor << "  " << join(edges, ",")
              << "\n";
  }
}

void show(const IndexArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list.list);
  const ListIndex index = list.index(arguments.name);
  const ListIndexCounts counts = list.index_counts(arguments.name);
  std::cout << (arguments.list.json ? render_json(index, counts) + "\n"
                                    : render_text(index, counts));
}

CLI::App* add_named(CLI::App& group, const std::string& name, const std::string& help,
                    IndexArguments& arguments) {
  CLI::App* verb = add_list_verb(group, name, help, arguments.list);
  verb->add_option("--name", arguments.name, "Name of the index")->required();
  return verb;
}

}  // namespace

void add_index_verbs(CLI::App& app) {
  static IndexArguments created, dropped, listed, shown;
  CLI::App* group = app.add_subcommand("index", "Manage the indexes of a list");
  group->require_subcommand(1);

  CLI::App* verb =
      add_named(*group, "create", "Create an index; computes missing descriptors", created);
  complete_with(
      verb->add_option("--descriptor", created.descriptor, "Id of the descriptor")->required(),
      [](const Words&) { return descriptor_ids(); });
  verb->add_option("--edges", created.edges, "Edges of the ranges, comma-separated")->required();
  add_robot_options(*verb, created.list);
  verb->add_option("--sensor-range", created.list.sensor_range, "Maximum range of the sensor, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_flag("--quiet", created.quiet, "No progress and no messages");
  verb->callback([] { create(created); });

  add_named(*group, "drop", "Remove an index", dropped)->callback([] { drop(dropped); });

  verb = add_list_verb(*group, "list", "List the indexes", listed.list);
  verb->add_flag("--json", listed.list.json, "One JSON object per index");
  verb->callback([] { list_indexes(listed); });

  verb = add_named(*group, "show", "Count the scenarios in each range", shown);
  verb->add_flag("--json", shown.list.json, "Print a JSON object");
  verb->callback([] { show(shown); });
}

}  // namespace slalom
