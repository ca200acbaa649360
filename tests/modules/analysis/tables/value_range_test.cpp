#include <slalom/analysis/cell.h>
#include <slalom/core/random.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/metrics/metric.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

std::vector<QuantityInfo> registered_quantities() {
  std::vector<QuantityInfo> infos;
  for (const Metric& metric : all_metrics()) infos.push_back(metric.info);
  for (const Descriptor& descriptor : all_descriptors()) infos.push_back(descriptor.info);
  return infos;
}

/// Within the range, every other time at a bound, where intervals leave it most easily.
double random_value(RandomEngine& engine, const ValueRange& range) {
  const double low = range.low ? *range.low : *range.high - 10;
  const double high = range.high ? *range.high : low + 10;
  if (range.low && uniform_int(engine, 0, 3) == 0) return low;
  if (range.high && uniform_int(engine, 0, 2) == 0) return high;
  return uniform_real(engine, low, high);
}

Cell random_cell(RandomEngine& engine, const QuantityInfo& info, int scenarios) {
  const ValueRange range = range_of(info.id);
  RowSums sums(1);
  std::vector<double> value(RowSums::padded(1));
  for (int run = 0; run < 2 * scenarios; ++run) {
    value[0] = random_value(engine, range);
    sums.add(value.data(), static_cast<std::uint32_t>(run / 2));
  }
  sums.end_part([](std::uint32_t scenario) { return scenario; });
  return make_cell(sums.cell(0), 2 * static_cast<std::size_t>(scenarios), 0, {info}, {}, info.id);
}

TEST(ValueRange, NoIntervalOfAMeanLeavesTheRangeOfItsQuantity) {
  RandomEngine engine(1);
  for (const QuantityInfo& info : registered_quantities()) {
    const ValueRange range = range_of(info.id);
    if (!range.low && !range.high) continue;
    for (int trial = 0; trial < 20; ++trial) {
      for (const int scenarios : {2, 3, 8, 30}) {
        const Cell cell = random_cell(engine, info, scenarios);
        EXPECT_TRUE(range.contains(cell.interval->low)) << info.id << " " << cell.interval->low;
        EXPECT_TRUE(range.contains(cell.interval->high)) << info.id << " " << cell.interval->high;
      }
    }
  }
}

TEST(ValueRange, OnlyClearancesAndALogarithmAreUnbounded) {
  std::set<std::string> unbounded;
  for (const QuantityInfo& info : registered_quantities()) {
    const ValueRange range = range_of(info.id);
    if (!range.low && !range.high) unbounded.insert(info.id);
  }
  EXPECT_EQ(unbounded, (std::set<std::string>{"log_dimensionless_jerk", "mean_clearance",
                                              "min_clearance", "min_mover_clearance"}));
}

TEST(ValueRange, OptimalityEndsAtOneAndSafetyDoesNot) {
  EXPECT_EQ(range_of("optimality").high, 1.0);
  EXPECT_FALSE(range_of("safety").high);
  EXPECT_EQ(range_of("detour_ratio").low, 1.0);
  EXPECT_FALSE(range_of("unknown").low);
}

TEST(ValueRange, TwoRunsNearTheOptimumHaveAnIntervalUpToOne) {
  RowSums sums(1);
  std::vector<double> value(RowSums::padded(1));
  for (const std::uint32_t scenario : {0U, 1U}) {
    value[0] = scenario == 0 ? 0.94 : 0.96;
    sums.add(value.data(), scenario);
  }
  sums.end_part([](std::uint32_t scenario) { return scenario; });
  QuantityInfo info;
  info.id = "optimality";
  const Cell cell = make_cell(sums.cell(0), 2, 0, {info}, {}, "cell");
  // t of one degree of freedom at 97.5 % is 12.7062, the standard error 0.01.
  EXPECT_NEAR(cell.interval->low, 0.95 - 0.127062, 1e-6);
  EXPECT_EQ(cell.interval->high, 1);
}

}  // namespace
}  // namespace slalom
