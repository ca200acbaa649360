// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/select_list.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/result_fields.h>

#include <algorithm>

namespace slalom {
namespace {

/// Computes missing values of the indexes in the condition; scenarios without a value are in no
/// range.
void complete_indexes(ScenarioList& list, const std::string& where, const DescribeOptions& options,
                      Progress& progress) {
  for (const ListIndex& index : list.indexes()) {
    if (where.find(index.name + "[") == std::string::npos) continue;
    if (list.missing_values(index.keys).empty()) continue;
    describe_list(list, options, {index.descriptor}, progress);
    const std::size_t missing_values = list.missing_values(index.keys).size();
    if (missing_values > 0)
      throw usage_error(list.path(),
                        count_text(missing_values, "scenario") + " without a value for index '" +
                            index.name + "'",
                        "the --robot-radius, --resolution and --sensor-range of `index create`");
  }
}

/// Descriptors in the condition and the order, sorted.
std::vector<std::string> used_descriptors(const ListSelection& selection) {
  const std::vector<std::string> known = descriptor_ids();
  std::vector<std::string> ids;
  for (const std::string& field : used_fields(selection.where))
    if (contains(known, field)) ids.push_back(field);
  for (const SelectionOrder& order : selection.order)
    if (contains(known, order.field)) ids.push_back(order.field);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace

std::string condition_text(const SelectionRequest& request) {
  if (request.ids.empty()) return request.where;
  return (request.where.empty() ? "" : request.where + ", ") + "ids " + request.ids;
}

std::string origin_text(const SelectionRequest& request) {
  std::string text;
  if (!request.where.empty()) text += " where " + request.where;
  if (!request.ids.empty()) text += " ids " + request.ids;
  if (!request.results.empty()) text += " results " + request.results;
  if (!request.order_by.empty()) text += " order by " + request.order_by;
  if (request.limit >= 0) text += " limit " + std::to_string(request.limit);
  return text;
}

DescriptorView describe_list(ScenarioList& list, DescribeOptions options,
                             std::vector<std::string> ids, Progress& progress) {
  if (ids.empty()) return {};
  options.ids = std::move(ids);
  make_describe_list(list, options, progress)->execute();
  return descriptor_view(options.ids, options);
}

ListSelection select_scenarios(ScenarioList& list, const SelectionRequest& request,
                               const DescribeOptions& options, Progress& progress) {
  ListSelection selection;
  SelectionVocabulary vocabulary = list.vocabulary(descriptor_ids());
  std::optional<ResultFields> results;
  if (!request.results.empty()) results.emplace(request.results).add_to(vocabulary);
  if (!request.where.empty()) selection.where = parse_selection(request.where, vocabulary);
  if (!request.order_by.empty())
    selection.order = parse_selection_order(request.order_by, vocabulary);
  if (!request.ids.empty()) {
    selection.hashes.emplace();
    for (const std::string& id : split(request.ids, ','))
      selection.hashes->push_back(list.find_entry(id).hash);
  }
  if (request.limit >= 0) selection.limit = static_cast<std::size_t>(request.limit);
  if (results) results->provide(selection);
  selection.view = describe_list(list, options, used_descriptors(selection), progress);
  complete_indexes(list, request.where, options, progress);
  return selection;
}

std::vector<std::pair<std::string, double>> parse_min_differences(const std::string& text,
                                                                  const std::string& where) {
  std::vector<std::pair<std::string, double>> differences;
  for (const std::string& part : split(text, ',')) {
    const std::vector<std::string> pair = split(part, ':');
    double difference = 0;
    if (pair.size() != 2 || !parse_number(pair[1], difference) || !(difference > 0))
      throw usage_error(where + " " + text, "invalid minimum difference '" + part + "'",
                        "DESCRIPTOR:NUMBER, the number > 0");
    descriptor(pair[0]);
    differences.emplace_back(pair[0], difference);
  }
  return differences;
}

}  // namespace slalom
