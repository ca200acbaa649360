// SPDX-License-Identifier: BSD-3-Clause
#include "combined_results.h"
#include "sibling_temp_file.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/result_file.h>
#include <slalom/results/outcome_words.h>

#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace slalom {
namespace {

/// Begins with a blank, which no name of a column does.
constexpr const char* kUnconditional = " unconditional ";

/// The columns of SQLite's tables are at most 2000.
constexpr std::size_t kMaxColumns = 1900;

Manifest manifest_of(const ResultTable& table) {
  Manifest manifest = table.manifest;
  manifest[kImportedKey] = manifest["campaign"] = table.source;
  if (!table.notes.empty()) manifest["imported_notes"] = join(table.notes, "\n");
  return manifest;
}

/// All columns with the id that they have in the file.
std::vector<std::pair<QuantityInfo, const ValueColumn*>> stored_columns(const ResultTable& table) {
  std::vector<std::pair<QuantityInfo, const ValueColumn*>> stored;
  for (const ValueColumn& column : table.metrics) stored.emplace_back(column.info(), &column);
  for (const ValueColumn& column : table.unconditional) {
    stored.emplace_back(column.info(), &column);
    stored.back().first.id = kUnconditional + column.info().id;
  }
  if (stored.size() > kMaxColumns)
    throw usage_error(table.source, count_text(stored.size(), "column") + " of numbers",
                      "at most " + std::to_string(kMaxColumns));
  return stored;
}

void expect_single_repetitions(const ResultTable& table) {
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> seen;
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::string where = table.source + ": " + table.scenario_names[table.scenario[run]] +
                              ", " + table.methods[table.method[run]];
    if (table.repetition[run] > std::numeric_limits<int>::max())
      throw usage_error(where, "repetition " + std::to_string(table.repetition[run]),
                        "at most " + std::to_string(std::numeric_limits<int>::max()));
    if (!seen.emplace(table.scenario[run], table.method[run], table.repetition[run]).second)
      throw usage_error(where, "two rows of repetition " + std::to_string(table.repetition[run]),
                        "each once; another column with --repetition-column NAME");
  }
}

RunRecord record_of(const ResultTable& table, std::size_t run) {
  RunRecord record;
  record.scenario_hash = table.scenario_hashes[table.scenario[run]];
  record.scenario_name = table.scenario_names[table.scenario[run]];
  record.method = table.methods[table.method[run]];
  record.repetition = static_cast<int>(table.repetition[run]);
  record.outcome = table.outcomes[table.outcome[run]];
  return record;
}

}  // namespace

void write_imported(const ResultTable& table, const std::string& path) {
  expect_single_repetitions(table);
  const auto columns = stored_columns(table);
  std::vector<QuantityInfo> infos;
  for (const auto& [info, column] : columns) infos.push_back(info);
  if (ResultFile::exists(path) && !is_imported(ResultFile::open(path).read_manifest()))
    throw file_error(path, "contains runs of a campaign", "an imported table, or a new file");
  SiblingTempFile temporary(path);
  ResultFile file = ResultFile::create(temporary.name(), manifest_of(table), {}, infos);
  for (std::size_t i = 0; i < table.scenario_hashes.size(); ++i)
    file.add_scenario({table.scenario_hashes[i], table.scenario_names[i], {}}, PackedScenario(),
                      {});
  for (std::size_t run = 0; run < table.size(); ++run) {
    RunRecord record = record_of(table, run);
    for (const auto& [info, column] : columns)
      record.metrics[info.id] = {info.version, column->is_na(run) ? Value::na(column->reason(run))
                                                                  : Value::of(column->number(run))};
    file.add_run(record);
  }
  file.commit();
  temporary.publish();
}

void expect_scenarios(const Manifest& manifest, const std::string& path) {
  if (is_imported(manifest))
    throw file_error(path, "is an imported table, without scenarios and settings",
                     "results of slalom-evaluate or slalom-simulate");
}

std::string id_of_imported(const std::string& id) {
  return starts_with(id, kUnconditional) ? id.substr(std::string(kUnconditional).size()) : id;
}

bool is_outcome_of_imported(const std::string& outcome) {
  return outcome == kUnknownOutcome || contains(known_outcomes(), outcome);
}

ResultTable finish_imported(ResultTable table) {
  std::vector<ValueColumn> metrics;
  for (ValueColumn& column : table.metrics) {
    if (column.wall_clock) continue;
    const std::string id = id_of_imported(column.info().id);
    if (id == column.info().id) {
      metrics.push_back(std::move(column));
    } else {
      column.set_id(id);
      table.unconditional.push_back(std::move(column));
    }
  }
  table.metrics = std::move(metrics);
  table.details.clear();  // no seeds, hashes and times
  sort_names(table);
  return table;
}

}  // namespace slalom
