// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/metrics/cycle_time.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(CycleTimeStatistics, AreMillisecondsByNearestRank) {
  std::vector<double> seconds;
  for (int i = 100; i >= 1; --i) seconds.push_back(0.001 * i);
  const auto statistics = cycle_time_statistics(seconds, 0.0905);
  // The smallest of 1, 2, ..., 100 ms with at least 50, 95, 99 % at or below it.
  EXPECT_EQ(statistics.size(), 6U);
  EXPECT_NEAR(statistics.at("cycle_time_mean"), 50.5, 1e-9);
  EXPECT_NEAR(statistics.at("cycle_time_p50"), 50, 1e-9);
  EXPECT_NEAR(statistics.at("cycle_time_p95"), 95, 1e-9);
  EXPECT_NEAR(statistics.at("cycle_time_p99"), 99, 1e-9);
  EXPECT_NEAR(statistics.at("cycle_time_max"), 100, 1e-9);
  EXPECT_NEAR(statistics.at("deadline_miss_ratio"), 0.1, 1e-9);  // 91, 92, ..., 100 ms
}

TEST(CycleTimeStatistics, OfOneCycleAreThatCycle) {
  for (const auto& [id, value] : cycle_time_statistics({0.002}, 1))
    EXPECT_DOUBLE_EQ(value, id == "deadline_miss_ratio" ? 0 : 2) << id;
}

TEST(CycleTimeStatistics, AreEmptyWithoutCycles) {
  EXPECT_TRUE(cycle_time_statistics({}, 1).empty());
}

}  // namespace
}  // namespace slalom
