#include "verbs.h"

#include <slalom/commands/describe_scenario.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_list.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>

namespace slalom {
namespace {

struct DescribeArguments {
  ListArguments list;
  std::string descriptors;
  std::string footprint;
  bool exact_confinement = false;
  int barn_visibility = 2021;
};

using Values = std::vector<DescribedValue>;

nlohmann::ordered_json details_of(const DescribedValue& described) {
  const Value& value = described.value;
  nlohmann::ordered_json json = {{"unit", described.info.unit},
                                 {"version", described.info.version},
                                 {"parameters", described.parameters},
                                 {"time_ms", described.time_ms}};
  if (value.standard_error()) json["standard_error"] = *value.standard_error();
  if (value.is_na()) json["na"] = value.reason();
  return json;
}

void print_json(const ScenarioList::Entry& entry, const Values& values) {
  nlohmann::ordered_json json = {{"id", entry.id}, {"name", entry.name}};
  for (const DescribedValue& described : values) {
    const QuantityInfo& info = described.info;
    const Value& value = described.value;
    if (value.is_na()) {
      json[info.id] = nullptr;
      json["na"][info.id] = value.reason();
    } else {
      json[info.id] = value.number();
    }
    if (value.standard_error()) json["standard_error"][info.id] = *value.standard_error();
  }
  for (const DescribedValue& described : values)
    json["details"][described.info.id] = details_of(described);
  std::cout << json.dump() << "\n";
}

void print_text(const ScenarioList::Entry& entry, const Values& values) {
  std::cout << entry.id << "  " << entry.name << "\n";
  for (const DescribedValue& described : values) {
    const QuantityInfo& info = described.info;
    const Value& value = described.value;
    std::cout << "  " << info.id << " = ";
    if (value.is_na()) {
      std::cout << "NA (" << value.reason() << ")";
    } else {
      std::cout << format_fixed(value.number(), 4);
      if (value.standard_error()) std::cout << " +- " << format_fixed(*value.standard_error(), 4);
      if (info.unit != "-") std::cout << " " << info.unit;
    }
    std::cout << "\n";
  }
}

Footprint robot_of(const DescribeArguments& arguments) {
  if (arguments.footprint.empty()) return Footprint::disc(arguments.list.robot_radius);
  try {
    return Footprint::parse(arguments.footprint);
  } catch (const std::invalid_argument& expected) {
    throw usage_error("--footprint", "'" + arguments.footprint + "' is no footprint",
                      expected.what());
  }
}

void run(const DescribeArguments& arguments) {
  ScenarioList list = ScenarioList::open(arguments.list.list);
  DescribeOptions options;
  options.ids = split(arguments.descriptors, ',');
  for (const std::string& id : options.ids) descriptor(id);  // a wrong one is told at once
  options.robot = robot_of(arguments);
  options.exact_confinement = arguments.exact_confinement;
  options.barn_visibility = arguments.barn_visibility;
  options.sensor_range = arguments.list.sensor_range;
  options.resolution = arguments.list.resolution;
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    Values values;
    // The values of one scenario reach the disk together: once instead of once each.
    list.in_one_step([&] { values = describe_scenario(list.read(entry.hash), options, list); });
    arguments.list.json ? print_json(entry, values) : print_text(entry, values);
    return true;
  });
}

}  // namespace

void add_describe_verb(CLI::App& app) {
  static DescribeArguments arguments;
  CLI::App* verb = add_list_verb(
      app, "describe", "Print descriptors; what is missing is computed and kept in the list",
      arguments.list);
  verb->add_option("--descriptors", arguments.descriptors, "Ids, comma separated (default: all)");
  add_robot_options(*verb, arguments.list);
  verb->add_option("--footprint", arguments.footprint,
                   "Convex polygon x,y; x,y; ... in m instead of the disc");
  verb->add_option("--sensor-range", arguments.list.sensor_range, "Range R of the sensor, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_flag("--exact-confinement", arguments.exact_confinement,
                 "Confinement from every free cell and without sampling; takes seconds");
  verb->add_option("--barn-visibility", arguments.barn_visibility,
                   "Which published version of barn_visibility")
      ->check(CLI::IsMember({2021, 2020}))
      ->capture_default_str();
  verb->add_flag("--json", arguments.list.json, "One JSON object per scenario");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
