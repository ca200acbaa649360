// SPDX-License-Identifier: BSD-3-Clause
#include "sibling_temp_file.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/own_columns.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace slalom {
namespace {

constexpr std::size_t kLongestId = 60;

void require_new_id(const std::string& id, const ResultTable& table) {
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_part = [&](char c) { return is_lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  if (id.empty() || id.size() > kLongestId || !is_lower(id[0]) ||
      !std::all_of(id.begin(), id.end(), is_part))
    throw usage_error("'" + id + "'", "cannot be the id of a column",
                      "at most 60 lower-case letters, digits and _, a letter first");
  if (find_metric(table, id) != nullptr || find_descriptor(table, id) != nullptr)
    throw usage_error(id, "the results have a column of this id", "another name");
}

/// Scenario, and of a run its method and repetition.
using RowKey = std::tuple<std::string, std::string, int>;

RowKey key_of(const RunRecord& run) {
  return {run.scenario_hash, run.method, run.repetition};
}

RowKey key_of(const ResultTable& table, std::size_t run) {
  return {table.scenario_hashes[table.scenario[run]],
          unmarked_name(table, table.methods[table.method[run]]),
          static_cast<int>(table.repetition[run])};
}

std::map<RowKey, Value> values_by_row(const ResultTable& table, const OwnColumn& column) {
  const ValueColumn& values = column.values;
  const std::size_t rows = column.is_descriptor ? table.scenario_hashes.size() : table.size();
  if (values.size() != rows)
    throw usage_error(
        values.info().id, "has " + count_text(values.size(), "value"),
        std::to_string(rows) + ", one per " + (column.is_descriptor ? "scenario" : "run"));
  std::map<RowKey, Value> by_row;
  for (std::size_t row = 0; row < rows; ++row) {
    const RowKey key =
        column.is_descriptor ? RowKey{table.scenario_hashes[row], "", 0} : key_of(table, row);
    if (values.is_na(row)) {
      by_row[key] = Value::na(values.reason(row));
      continue;
    }
    const double number = values.number(row);
    if (!values.info().range.contains(number))
      throw usage_error(values.info().id + " of " +
                            (column.is_descriptor ? table.scenario_names[row] : run_id(table, row)),
                        format_number(number) + " is out of range",
                        "a number " + values.info().range.text());
    by_row[key] = Value::of(number);
  }
  return by_row;
}

}  // namespace

void write_with_column(const ResultFile& file, const ResultTable& table, const OwnColumn& column,
                       const std::string& path) {
  const QuantityInfo& info = column.values.info();
  Manifest manifest = file.read_manifest();
  expect_scenarios(manifest, file.path());
  require_new_id(info.id, table);
  const std::map<RowKey, Value> values = values_by_row(table, column);
  std::vector<QuantityInfo> descriptors = file.descriptors(), metrics = file.metrics();
  (column.is_descriptor ? descriptors : metrics).push_back(info);
  manifest[kOwnColumnPrefix + info.id] = column.source;
  if (ResultFile::exists(path)) ResultFile::open(path);  // refuses a file of another kind
  SiblingTempFile temporary(path);
  ResultFile copy = ResultFile::create(temporary.name(), manifest, descriptors, metrics);
  for (const std::string& hash : table.scenario_hashes) {
    ScenarioRecord record = file.read_record(hash);
    if (column.is_descriptor)
      record.descriptors[info.id] = {info.version, values.at({hash, "", 0})};
    copy.add_scenario(record, file.read_scenario(hash), file.read_references(hash));
    for (RunRecord& run : file.read_runs(hash)) {
      if (!column.is_descriptor) run.metrics[info.id] = {info.version, values.at(key_of(run))};
      copy.add_run(run, file.read_timing(run), file.read_trajectory(run));
    }
  }
  copy.commit();
  temporary.publish();
}

}  // namespace slalom
