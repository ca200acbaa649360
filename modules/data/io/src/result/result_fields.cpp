// SPDX-License-Identifier: BSD-3-Clause
#include "combined_results.h"

#include <slalom/io/read_results.h>
#include <slalom/io/result_fields.h>
#include <slalom/io/result_file.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kOutcome = "outcome";

std::string first_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? shards_in(path).front() : path;
}

/// Metrics of the file, and the success, which every run has.
std::vector<QuantityInfo> metrics_in(const std::string& path) {
  std::vector<QuantityInfo> metrics = ResultFile::open(first_file(path)).metrics();
  const QuantityInfo success = success_info();
  if (std::none_of(metrics.begin(), metrics.end(),
                   [&](const QuantityInfo& info) { return info.id == success.id; }))
    metrics.insert(metrics.begin(), success);
  return metrics;
}

/// A mean of known values.
struct Mean {
  double sum = 0;
  int count = 0;
  std::string reason;  ///< why the first unknown value is

  void add(const ValueColumn& column, std::size_t run) {
    if (column.is_na(run)) {
      if (reason.empty()) reason = column.reason(run);
      return;
    }
    sum += column.number(run);
    ++count;
  }
  Value value() const { return count == 0 ? Value::na(reason) : Value::of(sum / count); }
};

ListField outcomes_of(const ResultTable& table, const std::string& method) {
  ListField field;
  field.is_text = true;
  for (std::size_t run = 0; run < table.size(); ++run)
    if (table.methods[table.method[run]] == method)
      field.texts[table.scenario_hashes[table.scenario[run]]].insert(
          table.outcomes[table.outcome[run]]);
  return field;
}

ListField means_of(const ResultTable& table, const std::string& metric, const std::string& method) {
  ListField field;
  const ValueColumn* column = find_metric(table, metric);
  if (column == nullptr) return field;
  field.unit = column->info().unit;
  std::map<std::string, Mean> means;
  for (std::size_t run = 0; run < table.size(); ++run)
    if (table.methods[table.method[run]] == method)
      means[table.scenario_hashes[table.scenario[run]]].add(*column, run);
  for (const auto& [hash, mean] : means) field.numbers[hash] = mean.value();
  return field;
}

}  // namespace

ResultFields::ResultFields(std::string path)
    : path_(std::move(path)),
      methods_(read_results(path_, std::vector<std::string>{}).methods),
      metrics_(metrics_in(path_)) {
  for (const std::string& method : methods_) {
    fields_[std::string(kOutcome) + "." + method] = {"", method};
    for (const QuantityInfo& metric : metrics_)
      fields_[metric.id + "." + method] = {metric.id, method};
  }
}

std::vector<std::string> ResultFields::of_method(const std::string& method) const {
  std::vector<std::string> fields = {std::string(kOutcome) + "." + method};
  for (const QuantityInfo& metric : metrics_) fields.push_back(metric.id + "." + method);
  return fields;
}

void ResultFields::add_to(SelectionVocabulary& vocabulary) const {
  for (const auto& [field, source] : fields_)
    (source.metric.empty() ? vocabulary.texts : vocabulary.numbers).push_back(field);
  for (const std::string& method : methods_)
    for (const QuantityInfo& metric : metrics_)
      name_field(vocabulary, metric.name + "." + method, metric.id + "." + method);
}

std::shared_ptr<const ListField> ResultFields::read(const std::string& field) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::shared_ptr<const ListField>& known = read_[field];
  if (known) return known;
  const Source& source = fields_.at(field);
  const bool outcome = source.metric.empty();
  const ResultTable table = read_results(
      path_, outcome ? std::vector<std::string>{} : std::vector<std::string>{source.metric});
  known = std::make_shared<const ListField>(
      outcome ? outcomes_of(table, source.method) : means_of(table, source.metric, source.method));
  return known;
}

void ResultFields::provide(ListSelection& selection) const {
  std::vector<std::string> used = used_fields(selection.where);
  for (const SelectionOrder& order : selection.order) used.push_back(order.field);
  for (const std::string& field : used)
    if (contains(field)) selection.fields[field] = read(field);
}

}  // namespace slalom
