#include "choice.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

/// Scenarios without the value of an index would silently be in none of its ranges.
void complete_indexes(ScenarioList& list, const ChoiceArguments& arguments) {
  for (const ListIndex& index : list.indexes()) {
    if (arguments.where.find(index.name + "[") == std::string::npos) continue;
    if (list.lacking(index.keys).empty()) continue;
    describe_all(list, arguments.list, {index.descriptor}, arguments.quiet);
    const std::size_t lacking = list.lacking(index.keys).size();
    if (lacking > 0)
      throw usage_error(
          list.path(),
          std::to_string(lacking) + " scenarios have no value for the index '" + index.name + "'",
          "--robot-radius, --resolution and --sensor-range as for `index create`");
  }
}

std::vector<std::string> hashes_of(const ScenarioList& list, const std::string& ids) {
  std::vector<std::string> hashes;
  for (const std::string& id : split(ids, ',')) hashes.push_back(list.find_entry(id).hash);
  return hashes;
}

}  // namespace

CLI::App* add_choice_verb(CLI::App& app, const std::string& name, const std::string& help,
                          ChoiceArguments& arguments) {
  CLI::App* verb = add_list_verb(app, name, help, arguments.list);
  verb->add_option("--where", arguments.where,
                   "Those for which this holds, such as \"density < 0.2 and tag = narrow\"");
  verb->add_option("--ids", arguments.ids, "Those with these ids or names, comma separated");
  add_robot_options(*verb, arguments.list);
  verb->add_option("--sensor-range", arguments.list.sensor_range, "Range R of the sensor, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb->add_flag("--quiet", arguments.quiet, "No progress and no messages");
  return verb;
}

void add_order_options(CLI::App& verb, ChoiceArguments& arguments) {
  verb.add_option("--order-by", arguments.order_by,
                  "Such as \"density desc, name\", instead of the order of the list");
  verb.add_option("--limit", arguments.limit, "At most so many")->check(CLI::NonNegativeNumber);
}

DescribeOptions describe_options(const ListArguments& arguments) {
  DescribeOptions options;
  options.robot = Footprint::disc(arguments.robot_radius);
  options.sensor_range = arguments.sensor_range;
  options.resolution = arguments.resolution;
  return options;
}

DescriptorView describe_all(ScenarioList& list, const ListArguments& arguments,
                            std::vector<std::string> ids, bool quiet) {
  if (ids.empty()) return {};
  DescribeOptions options = describe_options(arguments);
  options.ids = std::move(ids);
  const auto progress = make_terminal_progress(quiet);
  make_describe_list(list, options, *progress)->execute();
  return descriptor_view(options.ids, options);
}

ListSelection choose(ScenarioList& list, const ChoiceArguments& arguments) {
  ListSelection selection;
  const SelectionVocabulary vocabulary = list.vocabulary(descriptor_ids());
  if (!arguments.where.empty()) selection.where = parse_selection(arguments.where, vocabulary);
  if (!arguments.order_by.empty())
    selection.order = parse_selection_order(arguments.order_by, vocabulary);
  if (!arguments.ids.empty()) selection.hashes = hashes_of(list, arguments.ids);
  if (arguments.limit >= 0) selection.limit = static_cast<std::size_t>(arguments.limit);
  std::vector<std::string> ids = number_fields(selection.where, vocabulary);
  for (const SelectionOrder& order : selection.order)
    if (std::find(vocabulary.numbers.begin(), vocabulary.numbers.end(), order.field) !=
        vocabulary.numbers.end())
      ids.push_back(order.field);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  selection.view = describe_all(list, arguments.list, ids, arguments.quiet);
  complete_indexes(list, arguments);
  return selection;
}

ScenarioList open_or_create(const std::string& path) {
  return std::filesystem::exists(path) ? ScenarioList::open(path) : ScenarioList::create(path);
}

void tell_size(const ScenarioList& list, bool quiet) {
  const std::size_t size = list.size();
  if (!quiet)
    std::cerr << list.path() << ": " << size << (size == 1 ? " scenario\n" : " scenarios\n");
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
  std::cout << entry.id << "  " << to_string(entry.representation) << "  " << entry.name;
  for (const std::string& tag : entry.tags) std::cout << "  #" << tag;
  std::cout << "\n";
}

}  // namespace slalom
