// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/app/interrupt.h>
#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/result_fields.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

DescribeOptions describe_options(const ListArguments& arguments) {
  DescribeOptions options;
  options.robot = Footprint::disc(arguments.robot_radius);
  options.sensor_range = arguments.sensor_range;
  options.resolution = arguments.resolution;
  return options;
}

/// Descriptors, and the results in the file after --results.
Words field_names(const Words& words) {
  Words names = descriptor_ids();
  const auto option = std::find(words.begin(), words.end(), "--results");
  if (words.end() - option < 3) return names;
  try {
    const ResultFields results(*(option + 1));
    for (const std::string& method : results.methods())
      for (const std::string& field : results.of_method(method)) names.push_back(field);
  } catch (const Error&) {
    // There is no such file yet.
  }
  return names;
}

}  // namespace

CLI::App* add_filter_verb(CLI::App& app, const std::string& name, const std::string& help,
                          FilterArguments& arguments) {
  CLI::App* verb = add_list_verb(app, name, help, arguments.list);
  complete_with(
      verb->add_option(
          "--where", arguments.selection.where,
          "Scenarios that satisfy a condition, such as \"density < 0.2 and tag = narrow\""),
      field_names);
  verb->add_option("--results", arguments.selection.results,
                   "Results of these scenarios (.results, or a folder of shards): fields of "
                   "--where and --order-by such as outcome.METHOD, success.METHOD, "
                   "path_length.METHOD");
  verb->add_option("--ids", arguments.selection.ids,
                   "Scenarios with these ids or names, comma-separated");
  add_robot_options(*verb, arguments.list);
  verb->add_option("--sensor-range", arguments.list.sensor_range, "Maximum range of the sensor, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_flag("--quiet", arguments.quiet, "No progress and no messages");
  return verb;
}

void add_order_options(CLI::App& verb, FilterArguments& arguments) {
  complete_with(
      verb.add_option("--order-by", arguments.selection.order_by,
                      "Sort order, such as \"density desc, name\" (default: order of the list)"),
      field_names);
  verb.add_option("--limit", arguments.selection.limit, "Maximum number of scenarios")
      ->check(not_negative());
}

DescriptorView describe_all(ScenarioList& list, const ListArguments& arguments,
                            const std::vector<std::string>& ids, bool quiet) {
  return describe_list(list, describe_options(arguments), ids, *make_interruptible_progress(quiet));
}

ListSelection select_scenarios(ScenarioList& list, const FilterArguments& arguments) {
  ListSelection selection =
      select_scenarios(list, arguments.selection, describe_options(arguments.list),
                       *make_interruptible_progress(arguments.quiet));
  if (!arguments.quiet && arguments.selection.has_condition() && list.count(selection) == 0)
    std::cerr << list.path() << ": no scenario matches " << condition_text(arguments.selection)
              << "\n";
  return selection;
}

Scenario load_scenario(const ListArguments& arguments) {
  const ScenarioList list = ScenarioList::open(arguments.list);
  return list.read(list.find_entry(arguments.id).hash);
}

ScenarioList open_or_create(const std::string& path) {
  return std::filesystem::exists(path) ? ScenarioList::open(path) : ScenarioList::create(path);
}

void print_size(const ScenarioList& list, bool quiet) {
  if (!quiet) std::cerr << list.path() << ": " << count_text(list.size(), "scenario") << "\n";
}

void print_entry(const ScenarioList::Entry& entry, bool json) {
  if (json) {
    nlohmann::ordered_json object = {{"id", entry.id},
                                     {"name", entry.name},
                                     {"representation", to_string(entry.representation)},
                                     {"generator", nullptr},
                                     {"seed", nullptr},
                                     {"tags", entry.tags}};
    if (!entry.generator.empty()) object["generator"] = entry.generator;
    if (entry.seed) object["seed"] = *entry.seed;
    std::cout << object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << entry.id << "  " << to_string(entry.representation) << "  "
            << printable_line(entry.name);
  for (const std::string& tag : entry.tags) std::cout << "  #" << printable_line(tag);
  std::cout << "\n";
}

}  // namespace slalom
