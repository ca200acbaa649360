// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/run_record.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

RunRecord run_of(const std::string& scenario, const std::string& hash, const std::string& method,
                 int repetition) {
  RunRecord run;
  run.scenario_name = scenario;
  run.scenario_hash = hash;
  run.method = method;
  run.repetition = repetition;
  return run;
}

TEST(TimingInfo, IsAFractionForRatiosAndElseATime) {
  const QuantityInfo time = timing_info("cycle_time_p95"),
                     ratio = timing_info("deadline_miss_ratio");
  EXPECT_EQ(time.unit, "ms");
  EXPECT_EQ(range_notation(time.range), "0..");
  EXPECT_EQ(ratio.unit, "-");
  EXPECT_EQ(range_notation(ratio.range), "0..1");
}

TEST(RunId, IsEightDigitsOfTheHashMethodAndRepetition) {
  EXPECT_EQ(run_id(run_of("hall", "0123456789abcdef", "nd", 12)), "01234567/nd/12");
  EXPECT_EQ(run_id(run_of("hall", "abc", "nd", 0)), "abc/nd/0");
}

TEST(VersionedValue, OfAnotherVersionIsNotAvailable) {
  EXPECT_EQ(value_of_version({2, Value::of(0.5)}, 2), Value::of(0.5));
  EXPECT_EQ(value_of_version({1, Value::of(0.5)}, 2), Value::na("other version 1"));
  EXPECT_EQ(value_of_version({1, Value::na("stuck")}, 2), Value::na("stuck"));
}

TEST(VersionedValue, IsNotComputedByDefault) {
  const VersionedValue value;
  EXPECT_EQ(value.version, 1);
  ASSERT_TRUE(value.value.is_na());
  EXPECT_EQ(value.value.reason(), "not computed");
}

}  // namespace
}  // namespace slalom
