// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/lack_of_time.h>
#include <slalom/results/table_builder.h>

#include <algorithm>

namespace slalom {
namespace {

std::vector<ValueColumn> empty_columns(std::vector<QuantityInfo> infos) {
  std::sort(infos.begin(), infos.end(),
            [](const QuantityInfo& a, const QuantityInfo& b) { return a.id < b.id; });
  return {infos.begin(), infos.end()};
}

}  // namespace

TableBuilder::TableBuilder(std::vector<QuantityInfo> descriptors,
                           std::vector<QuantityInfo> metrics) {
  table_.descriptors = empty_columns(std::move(descriptors));
  table_.metrics = empty_columns(std::move(metrics));
}

std::uint32_t TableBuilder::index_of_scenario(const std::string& hash, const std::string& name) {
  const std::uint32_t index = scenarios_.index_of(hash);
  if (index == table_.scenario_names.size()) table_.scenario_names.push_back(name);
  return index;
}

void TableBuilder::add_scenario(const ScenarioRecord& record) {
  index_of_scenario(record.hash, record.name);
  records_[record.hash] = record;
}

void TableBuilder::add_run(const RunRecord& run, const RunTiming& timing) {
  const std::size_t row = table_.size();
  table_.scenario.push_back(index_of_scenario(run.scenario_hash, run.scenario_name));
  table_.method.push_back(methods_.index_of(run.method));
  table_.outcome.push_back(outcomes_.index_of(run.outcome));
  table_.repetition.push_back(static_cast<std::uint32_t>(run.repetition));
  table_.details.push_back(
      {run.seed, run.outcome_detail, run.trajectory_hash, timing.wall_seconds});
  if (std::string lack = lack_of_time_in(run.outcome_detail); !lack.empty())
    table_.lack_of_time[run.scenario_hash] = std::move(lack);
  for (ValueColumn& column : table_.metrics) {
    const auto found = run.metrics.find(column.info().id);
    column.add(found == run.metrics.end() ? Value::na(kNotComputed) : found->second.value);
  }
  for (const auto& [id, number] : timing.values) {
    ValueColumn& column = figures_.try_emplace(id, wall_clock_column(id)).first->second;
    column.pad(row);
    column.add_number(number);
  }
}

ResultTable TableBuilder::finish() {
  for (ValueColumn& column : table_.descriptors) {
    for (const std::string& hash : table_.scenario_hashes) {
      const auto& values = records_[hash].descriptors;
      const auto found = values.find(column.info().id);
      column.add(found == values.end() ? Value::na(kNotRecorded)
                                       : value_of_version(found->second, column.info().version));
    }
  }
  for (auto& [id, column] : figures_) {
    column.pad(table_.size());
    table_.metrics.push_back(std::move(column));
  }
  sort_rows(table_);
  add_success(table_);
  return std::move(table_);
}

}  // namespace slalom
