// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/campaign/describe_scenario.h>
#include <slalom/commands/describe_list.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/scenario_list.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>

namespace slalom {
namespace {

struct DescribeArguments {
  ListArguments list;
  std::string descriptors;
  std::string footprint;
  bool exact_confinement = false;
  int barn_visibility = 2021;
};

/// The values of a scenario with the wall-clock time of the lookup or computation of each, ms.
/// Intermediate results that are shared by several descriptors (cells, distances, the shortest
/// path) count for the first of them.
struct TimedValues {
  std::vector<KeyedValue> values;
  std::vector<double> times;
};

TimedValues describe_timed(const Scenario& scenario, const DescribeOptions& options,
                           DescriptorStore& store) {
  using Clock = std::chrono::steady_clock;
  TimedValues timed;
  Clock::time_point before = Clock::now();
  timed.values = describe_scenario(scenario, options, store, [&](const KeyedValue&) {
    const Clock::time_point now = Clock::now();
    timed.times.push_back(std::chrono::duration<double, std::milli>(now - before).count());
    before = now;
  });
  return timed;
}

nlohmann::ordered_json details_of(const KeyedValue& described, double time_ms) {
  const Value& value = described.value;
  nlohmann::ordered_json json = {{"unit", descriptor(described.key.id).info.unit},
                                 {"version", described.key.version},
                                 {"parameters", described.key.parameters},
                                 {"time_ms", time_ms}};
  if (value.standard_error()) json["standard_error"] = *value.standard_error();
  if (value.is_na()) json["na"] = value.reason();
  return json;
}

void print_json(const ScenarioList::Entry& entry, const TimedValues& timed) {
  nlohmann::ordered_json json = {{"id", entry.id}, {"name", entry.name}};
  for (const auto& [key, value] : timed.values) {
    if (value.is_na()) {
      json[key.id] = nullptr;
      json["na"][key.id] = value.reason();
    } else {
      json[key.id] = value.number();
    }
    if (value.standard_error()) json["standard_error"][key.id] = *value.standard_error();
  }
  for (std::size_t i = 0; i < timed.values.size(); ++i)
    json["details"][timed.values[i].key.id] = details_of(timed.values[i], timed.times[i]);
  std::cout << json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
}

void print_text(const ScenarioList::Entry& entry, const std::vector<KeyedValue>& values) {
  std::cout << entry.id << "  " << printable_line(entry.name) << "\n";
  for (const auto& [key, value] : values) {
    const std::string& unit = descriptor(key.id).info.unit;
    std::cout << "  " << key.id << " = ";
    if (value.is_na()) {
      std::cout << "NA (" << value.reason() << ")";
    } else {
      std::cout << format_fixed(value.number(), 4);
      if (value.standard_error()) std::cout << " +- " << format_fixed(*value.standard_error(), 4);
      if (unit != "-") std::cout << " " << unit;
    }
    std::cout << "\n";
  }
}

Footprint robot_of(const DescribeArguments& arguments) {
  return arguments.footprint.empty() ? Footprint::disc(arguments.list.robot_radius)
                                     : Footprint::parse(arguments.footprint, "--footprint");
}

void run(const DescribeArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.list.list);
  DescribeOptions options;
  options.ids = split(arguments.descriptors, ',');
  for (const std::string& id : options.ids) descriptor(id);  // throws for an unknown id
  options.robot = robot_of(arguments);
  options.exact_confinement = arguments.exact_confinement;
  options.barn_visibility = arguments.barn_visibility;
  options.sensor_range = arguments.list.sensor_range;
  options.resolution = arguments.list.resolution;
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    TimedValues timed;
    // Writes the values of one scenario in one transaction.
    list.in_transaction([&] { timed = describe_timed(list.read(entry.hash), options, list); });
    arguments.list.json ? print_json(entry, timed) : print_text(entry, timed.values);
    return true;
  });
}

}  // namespace

void add_describe_verb(CLI::App& app) {
  static DescribeArguments arguments;
  CLI::App* verb = add_list_verb(
      app, "describe", "Print descriptors; computes missing values and stores them in the list",
      arguments.list);
  complete_with(verb->add_option("--descriptors", arguments.descriptors,
                                 "Descriptor ids, comma-separated (default: all)"),
                [](const Words&) { return descriptor_ids(); });
  add_robot_options(*verb, arguments.list);
  verb->add_option("--footprint", arguments.footprint,
                   "Polygon x,y; x,y; ... (m) instead of the disc");
  verb->add_option("--sensor-range", arguments.list.sensor_range, "Maximum range of the sensor, m")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_flag("--exact-confinement", arguments.exact_confinement,
                 "Exact confinement from all free cells instead of sampling; takes seconds");
  verb->add_option("--barn-visibility", arguments.barn_visibility,
                   "Published version of barn_visibility")
      ->check(in_range(2020, 2021))
      ->capture_default_str();
  verb->add_flag("--json", arguments.list.json, "One JSON object per scenario");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
