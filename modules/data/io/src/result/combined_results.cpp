// SPDX-License-Identifier: BSD-3-Clause
#include "combined_results.h"
#include "unequal.h"

#include <slalom/core/error.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/merge_results.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>
#include <tuple>

namespace slalom {
namespace {

bool is_measured(const ValueColumn& column) {
  return column.wall_clock;
}

/// The columns of which all files of a campaign have the same: all but wall-clock figures.
std::vector<ValueColumn> empty_columns(const std::vector<ValueColumn>& columns) {
  std::vector<ValueColumn> empty;
  for (const ValueColumn& column : columns) {
    if (is_measured(column)) continue;
    empty.emplace_back(column.info());
  }
  return empty;
}

void expect_same_columns(const std::vector<ValueColumn>& here,
                         const std::vector<ValueColumn>& there, const std::string& file) {
  const auto end_of = [](const auto& columns) {
    return std::find_if(columns.begin(), columns.end(), is_measured);
  };
  const bool same =
      std::equal(here.begin(), end_of(here), there.begin(), end_of(there),
                 [](const ValueColumn& a, const ValueColumn& b) {
                   return a.info().id == b.info().id && a.info().version == b.info().version;
                 });
  if (!same)
    throw file_error(file, "contains other metrics or descriptors than a file before it", kEqual);
}

void copy_value(const ValueColumn& from, std::size_t row, ValueColumn& to) {
  if (from.is_na(row)) {
    to.add_na(from.reason(row));
  } else {
    to.add_number(from.number(row));
  }
}

/// The wall-clock figures that only some files contain, in the order of their ids.
void add_measured_columns(ResultTable& table, const std::vector<ValueColumn>& columns) {
  for (const ValueColumn& column : columns) {
    const std::string& id = column.info().id;
    const auto at = std::find_if(
        table.metrics.begin(), table.metrics.end(),
        [&](const ValueColumn& other) { return is_measured(other) && other.info().id >= id; });
    if (!is_measured(column) || (at != table.metrics.end() && at->info().id == id)) continue;
    table.metrics.insert(at, wall_clock_column(id))->pad(table.size());
  }
}

/// The index in the combined names of each name of a file.
std::vector<std::uint32_t> indexes_of(const std::vector<std::string>& names, NameIndex& index) {
  std::vector<std::uint32_t> indexes;
  indexes.reserve(names.size());
  for (const std::string& name : names) indexes.push_back(index.index_of(name));
  return indexes;
}

void refer_to(const std::vector<std::uint32_t>& indexes, std::vector<std::uint32_t>& rows) {
  for (std::uint32_t& row : rows) row = indexes[row];
}

}  // namespace

void CombinedResults::add(FileRows part) {
  ResultTable& added = part.table;
  if (files_++ == 0) {
    table_.manifest = added.manifest;
    table_.manifest.erase(kShardKey);
    table_.metrics = empty_columns(added.metrics);
    table_.descriptors = empty_columns(added.descriptors);
  } else {
    expect_same_campaign(table_.manifest, added.manifest, added.source,
                         "results of the same campaign");
    add_repeated_runs(added.manifest, table_.manifest);
    expect_same_columns(table_.metrics, added.metrics, added.source);
    expect_same_columns(table_.descriptors, added.descriptors, added.source);
  }
  const std::string name = std::filesystem::path(added.source).filename().string();
  table_.lack_of_time.merge(added.lack_of_time);
  for (const std::string& what : added.damaged) table_.damaged.push_back(name + ": " + what);
  const bool is_shared = add_scenarios(part);
  refer_to(indexes_of(added.methods, methods_), added.method);
  refer_to(indexes_of(added.outcomes, outcomes_), added.outcome);
  std::vector<std::size_t> rows(added.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  add_runs(part, is_shared ? find_new_runs(part) : rows);
}

ResultTable CombinedResults::finish() {
  runs_ = {};  // frees their memory before the rows are sorted
  return finish_table(std::move(table_));
}

/// Returns whether a file before it contains some of its scenarios: shards share none.
bool CombinedResults::add_scenarios(FileRows& part) {
  ResultTable& added = part.table;
  const std::vector<std::uint32_t> indexes = indexes_of(added.scenario_hashes, hashes_);
  bool is_shared = false;
  for (std::size_t i = 0; i < indexes.size(); ++i) {
    const std::uint32_t index = indexes[i];
    if (index < scenarios_.size()) {
      is_shared = true;
      if (scenarios_[index] && part.scenarios[i] && *scenarios_[index] != *part.scenarios[i])
        throw unequal(added.source, "scenario " + added.scenario_hashes[i]);
      continue;
    }
    scenarios_.push_back(part.scenarios[i]);
    table_.scenario_names.push_back(added.scenario_names[i]);
    for (std::size_t column = 0; column < added.descriptors.size(); ++column)
      copy_value(added.descriptors[column], i, table_.descriptors[column]);
  }
  refer_to(indexes, added.scenario);
  return is_shared;
}

/// The runs of a file that the table does not contain yet.
std::vector<std::size_t> CombinedResults::find_new_runs(const FileRows& part) const {
  const auto key_of = [](const ResultTable& table, std::size_t run) {
    return std::tuple(table.scenario[run], table.method[run], table.repetition[run]);
  };
  const ResultTable& added = part.table;
  const std::set<std::uint32_t> scenarios(added.scenario.begin(), added.scenario.end());
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::size_t> known;
  for (std::size_t run = 0; run < table_.size(); ++run)
    if (scenarios.count(table_.scenario[run]) > 0) known.emplace(key_of(table_, run), run);
  std::vector<std::size_t> rows;
  for (std::size_t run = 0; run < added.size(); ++run) {
    const auto found = known.find(key_of(added, run));
    if (found == known.end()) {
      rows.push_back(run);
    } else if (runs_[found->second] != part.runs[run]) {
      const std::uint32_t outcomes[] = {table_.outcome[found->second], added.outcome[run]};
      throw unequal(added.source, "run " + run_id(table_, found->second),
                    std::any_of(std::begin(outcomes), std::end(outcomes), [&](std::uint32_t i) {
                      return ended_at_time_limit(table_.outcomes[i]);
                    }));
    }
  }
  return rows;
}

void CombinedResults::add_runs(FileRows& part, const std::vector<std::size_t>& rows) {
  ResultTable& added = part.table;
  add_measured_columns(table_, added.metrics);
  for (const std::size_t row : rows) {
    runs_.push_back(part.runs[row]);
    table_.scenario.push_back(added.scenario[row]);
    table_.method.push_back(added.method[row]);
    table_.outcome.push_back(added.outcome[row]);
    table_.repetition.push_back(added.repetition[row]);
    if (!added.details.empty()) table_.details.push_back(std::move(added.details[row]));
  }
  for (ValueColumn& column : table_.metrics) {
    const ValueColumn* values = find_metric(added, column.info().id);
    if (values == nullptr) {
      column.pad(table_.size());
      continue;
    }
    for (const std::size_t row : rows) copy_value(*values, row, column);
  }
}

ResultTable finish_table(ResultTable table) {
  if (is_imported(table.manifest)) return finish_imported(std::move(table));
  sort_rows(table);  // runs are written in any order
  add_success(table);
  if (std::string note = note_on_time(table); !note.empty()) table.notes.push_back(std::move(note));
  for (std::string& note : kept_run_notes(table.manifest)) table.notes.push_back(std::move(note));
  return table;
}

}  // namespace slalom
