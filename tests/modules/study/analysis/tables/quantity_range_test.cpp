// SPDX-License-Identifier: BSD-3-Clause
// No interval of a table or comparison leaves the range of its quantity: all registered ones.
#include "result_fixture.h"

#include <slalom/analysis/cell.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/metric.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::vector<QuantityInfo> registered_quantities() {
  std::vector<QuantityInfo> infos;
  for (const Metric& metric : all_metrics()) infos.push_back(metric.info);
  for (const Descriptor& descriptor : all_descriptors()) infos.push_back(descriptor.info);
  for (const char* id : {"cycle_time_mean", "deadline_miss_ratio"})
    infos.push_back(timing_info(id));
  return infos;
}

/// Within the range, every other time at a bound, where intervals leave it most easily.
double random_value(RandomEngine& engine, const QuantityInfo& info) {
  const Range& range = info.range;
  const double low = range.bounded_below() ? range.low : std::min(range.high, 0.0) - 10;
  const double high = range.bounded_above() ? range.high : low + 10;
  if (info.is_rate()) return uniform_int(engine, 0, 3) == 0 ? 0 : 1;
  if (uniform_int(engine, 0, 3) == 0) return low;
  if (uniform_int(engine, 0, 2) == 0) return high;
  return uniform_real(engine, low, high);
}

/// Two methods with two runs of each in every scenario, and this quantity alone.
ResultTable random_table(RandomEngine& engine, const QuantityInfo& info, int scenarios) {
  ResultFixture fixture;
  for (int i = 0; i < scenarios; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (const std::string method : {"a", "b"})
      for (int repetition = 0; repetition < 2; ++repetition)
        fixture.add_run(hash, method, 0.5, repetition);
  }
  ResultTable table = std::move(fixture.table);
  table.metrics = {ValueColumn(info)};
  for (std::size_t run = 0; run < table.size(); ++run)
    table.metrics[0].add_number(random_value(engine, info));
  return table;
}

/// The numbers of "[0.1, 0.9]".
std::pair<double, double> printed_numbers(const std::string& interval) {
  const std::vector<std::string> ends =
      split_nonempty(interval.substr(1, interval.size() - 2), ',');
  double low = 0, high = 0;
  EXPECT_TRUE(parse_number(ends.at(0), low) && parse_number(ends.at(1), high)) << interval;
  return {low, high};
}

TEST(QuantityRange, NoPrintedIntervalLeavesIt) {
  RandomEngine engine(1);
  for (const QuantityInfo& info : registered_quantities()) {
    for (int trial = 0; trial < 8; ++trial) {
      for (const int scenarios : {2, 3, 8, 30}) {
        const ResultTable table = random_table(engine, info, scenarios);
        std::vector<std::size_t> runs(table.size());
        for (std::size_t run = 0; run < runs.size(); ++run) runs[run] = run;
        const Cell cell = make_cell(table, runs, table.metrics[0], {});
        const Column column{info};
        const std::string text = interval_text(cell, digits_for({&cell}, column));
        EXPECT_EQ(text.empty(), states_median(info) && scenarios < 6) << info.id;
        if (text.empty()) continue;
        const auto [low, high] = printed_numbers(text);
        EXPECT_TRUE(info.range.contains(low)) << info.id << " " << low;
        EXPECT_TRUE(info.range.contains(high)) << info.id << " " << high;
        EXPECT_LE(low, high) << info.id;
      }
    }
  }
}

TEST(QuantityRange, NoIntervalOfADifferenceLeavesItsRange) {
  RandomEngine engine(1);
  for (const QuantityInfo& info : registered_quantities()) {
    if (!info.range.is_bounded()) continue;
    const double largest = info.range.high - info.range.low;
    for (const int scenarios : {2, 3, 8, 30}) {
      const auto family = compare_methods(random_table(engine, info, scenarios), {info.id}, "", {});
      const auto& interval = family.at(0).interval;
      ASSERT_TRUE(interval) << info.id;
      EXPECT_GE(interval->low, -largest) << info.id;
      EXPECT_LE(interval->high, largest) << info.id;
    }
  }
}

TEST(QuantityRange, EachQuantityOfZeroAndOneIsARate) {
  for (const std::string id : {"success", "mover_collision", "stood_at_contact"}) {
    const QuantityInfo& info = metric(id).info;
    ASSERT_TRUE(info.is_rate()) << id;
    ResultFixture fixture;
    for (int i = 0; i < 8; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.1));
      for (const std::string method : {"a", "b"}) fixture.add_run(hash, method, 0.5);
    }
    ResultTable table = std::move(fixture.table);
    table.metrics = {ValueColumn(info)};
    // One of eight runs of a, all of b: 0.125 has the Wilson interval [0.0224, 0.4709] (n = 8, by
    // hand: (0.125 + z2/16 -+ z sqrt(0.125 0.875 / 8 + z2/256)) / (1 + z2/8) with z = 1.95996).
    for (std::size_t run = 0; run < table.size(); ++run)
      table.metrics[0].add_number(table.method[run] == 1 || run == 0 ? 1 : 0);
    std::vector<std::size_t> of_a;
    for (std::size_t run = 0; run < table.size(); ++run)
      if (table.method[run] == 0) of_a.push_back(run);
    const Cell cell = make_cell(table, of_a, table.metrics[0], {});
    EXPECT_NEAR(cell.interval->low, 0.0224, 5e-5) << id;
    EXPECT_NEAR(cell.interval->high, 0.4709, 5e-5) << id;
    const PairedComparison comparison = compare_methods(table, {id}, "", {}).at(0);
    EXPECT_EQ(comparison.test, PairedComparison::Test::McNemarExact) << id;
    EXPECT_NEAR(comparison.p, 2 * std::pow(0.5, 7), 1e-12) << id;  // 7 of 7 discordant pairs
  }
}

TEST(QuantityRange, TwoRunsNearTheOptimumHaveAnIntervalBelowOne) {
  RowSums sums(1);
  std::vector<double> value(RowSums::padded(1));
  for (const std::uint32_t scenario : {0U, 1U}) {
    value[0] = scenario == 0 ? 0.94 : 0.96;
    sums.add(value.data(), scenario);
  }
  sums.end_part([](std::uint32_t scenario) { return scenario; });
  const Cell cell = make_cell(sums.cell(0), 2, 0, {metric("optimality").info}, {});
  EXPECT_LT(cell.interval->low, 0.94);
  EXPECT_GE(cell.interval->low, 0);
  EXPECT_GT(cell.interval->high, 0.96);
  EXPECT_LE(cell.interval->high, 1);
}

}  // namespace
}  // namespace slalom
