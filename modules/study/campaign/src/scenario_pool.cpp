// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_pool.h"

#include <slalom/campaign/describe_scenario.h>
#include <slalom/core/parallel.h>

#include <algorithm>
#include <utility>

namespace slalom {
namespace {

Value describe(const Scenario& scenario, const std::string& id, const CampaignOptions& options) {
  DescribeOptions describe = describe_options(options);
  describe.ids = {id};
  MemoryDescriptorStore store;
  return describe_scenario(scenario, describe, store).front().value;
}

std::vector<Bin> bins_of(const std::vector<Value>& values, const BinSpec& spec) {
  ResultTable table;
  ValueColumn& column = table.descriptors.emplace_back(descriptor(spec.descriptor).info);
  for (const Value& value : values) column.add(value);
  return make_bins(spec, table);
}

}  // namespace

ScenarioPool::ScenarioPool(std::vector<Scenario> scenarios, BatchSize batch_size)
    : scenarios_(std::move(scenarios)), batch_size_(batch_size), bins_(1) {
  for (std::size_t i = 0; i < scenarios_.size(); ++i) bins_[0].scenarios.push_back(i);
}

ScenarioPool::ScenarioPool(std::vector<Scenario> scenarios, BatchSize batch_size, BinSpec& rows,
                           const CampaignOptions& options, const Execution& execution)
    : ScenarioPool(std::move(scenarios), batch_size) {
  if (rows.kind == BinSpec::Kind::All) return;
  bins_.clear();
  const auto values = parallel_map(scenarios_.size(), execution.workers, [&](std::size_t i) {
    if (execution.is_interrupted()) return Value::na("interrupted");
    return describe(scenarios_[i], rows.descriptor, options);
  });
  if (execution.is_interrupted()) return;
  for (const Bin& bin : bins_of(values, rows)) bins_.push_back({bin, {}, 0});
  for (std::size_t i = 0; i < values.size(); ++i) assign_to_bin(i, values[i]);
  rows = with_edges(rows.descriptor, all_bins());
}

std::vector<Scenario> ScenarioPool::next_batch(const std::vector<bool>& open) {
  std::vector<std::size_t> chosen;
  for (std::size_t b = 0; b < bins_.size(); ++b) {
    if (!open[b]) continue;
    BinScenarios& bin = bins_[b];
    const std::size_t n = std::min(bin.scenarios.size() - bin.taken, batch_size_(bin.taken));
    const auto first = bin.scenarios.begin() + static_cast<std::ptrdiff_t>(bin.taken);
    chosen.insert(chosen.end(), first, first + static_cast<std::ptrdiff_t>(n));
    bin.taken += n;
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<Scenario> batch;
  for (const std::size_t i : chosen) batch.push_back(scenarios_[i]);
  return batch;
}

void ScenarioPool::assign_to_bin(std::size_t scenario, const Value& value) {
  if (value.is_na()) return;
  for (BinScenarios& bin : bins_) {
    if (bin.bin.contains(value.number())) return bin.scenarios.push_back(scenario);
  }
}

std::vector<Bin> ScenarioPool::all_bins() const {
  std::vector<Bin> bins;
  for (const BinScenarios& bin : bins_) bins.push_back(bin.bin);
  return bins;
}

}  // namespace slalom
