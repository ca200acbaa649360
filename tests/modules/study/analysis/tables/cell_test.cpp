// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/cell.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

class CellTest : public ::testing::Test {
 protected:
  CellTest() {
    for (const double optimality : {0.9, 0.8, 0.7, -1.0}) {
      fixture_.add_run(fixture_.add_scenario(Value::of(0.1)), "nd", optimality);
    }
  }

  Cell cell(const std::string& id) {
    return make_cell(fixture_.table, {0, 1, 2, 3}, *find_metric(fixture_.table, id), {});
  }

  /// Success is then derived from the outcomes.
  void set_outcome_of_first_run(const std::string& outcome) {
    ResultTable& table = fixture_.table;
    table.outcome[0] = static_cast<std::uint32_t>(table.outcomes.size());
    table.outcomes.push_back(outcome);
    fixture_.erase_metric("success");
    add_success(table);
  }

  ResultFixture fixture_;
};

TEST_F(CellTest, CountsMissingValuesByReason) {
  const Cell optimality = cell("optimality");
  EXPECT_EQ(optimality.n, 4u);
  EXPECT_EQ(optimality.available, 3u);
  EXPECT_EQ(optimality.na.at("collision"), 1u);
  EXPECT_NEAR(*optimality.estimate, 0.8, 1e-12);
  EXPECT_NEAR(*optimality.deviation, 0.1, 1e-12);
  EXPECT_NEAR(*optimality.median, 0.8, 1e-12);
  const GroupSums groups = {{0.9, 0.8, 0.7}, {1, 1, 1}};
  const auto gaffke = gaffke_interval(moments_of(groups), groups, Range::between(0, 1), 0.95);
  EXPECT_DOUBLE_EQ(optimality.interval->low, gaffke->low);
  EXPECT_DOUBLE_EQ(optimality.interval->high, gaffke->high);
}

TEST_F(CellTest, AScoreHasTheHurdleInterval) {
  ValueColumn spl({"spl", 3, "SPL", "-", Direction::Up, QuantityKind::Score, Range::between(0, 1)});
  for (const double value : {0.9, 0.8, 0.7, 0.0}) spl.add_number(value);
  const Cell cell = make_cell(fixture_.table, {0, 1, 2, 3}, spl, {});
  const ScoreMoments moments = score_moments({{0.9, 0.8, 0.7, 0}, {1, 1, 1, 1}}, {1, 1, 1, 0});
  const Interval hurdle = hurdle_interval(moments, 1, 0.95);
  EXPECT_NEAR(cell.interval->low, hurdle.low, 1e-12);
  EXPECT_NEAR(cell.interval->high, hurdle.high, 1e-12);
}

TEST_F(CellTest, AMeanOfValuesWithoutBoundsHasNoIntervalButAMedianHas) {
  ValueColumn time(
      {"time_to_goal", 1, "Time", "s", Direction::Down, QuantityKind::Amount, Range::at_least(0)});
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < 8; ++i) {
    if (i >= 4) fixture_.add_run(fixture_.add_scenario(Value::of(0.1)), "nd", 0.5);
    time.add_number(static_cast<double>(i * i));
    runs.push_back(i);
  }
  const Cell cell = make_cell(fixture_.table, runs, time, {});
  EXPECT_FALSE(cell.interval);
  EXPECT_EQ(cell.interval_na, "no upper bound");
  EXPECT_DOUBLE_EQ(*cell.median, 12.5);
  // P(at most 0 of 8 below the median) = 1 / 256, of at most 1 9 / 256 > 0.025.
  EXPECT_EQ(cell.median_interval->low, 0);
  EXPECT_EQ(cell.median_interval->high, 49);
  EXPECT_EQ(estimate_text(cell, 1), "median 12.5");
  EXPECT_EQ(interval_text(cell, 1), "[0.0, 49.0]");
  EXPECT_EQ(support_text(cell, {time.info()}, 1), "mean 17.5 ±17.8 n = 8");
}

TEST_F(CellTest, SuccessIsARateWithAWilsonInterval) {
  const Cell success = cell("success");
  EXPECT_DOUBLE_EQ(*success.estimate, 0.75);
  EXPECT_DOUBLE_EQ(success.interval->low, wilson_interval(0.75, 4, 0.95).low);
}

TEST_F(CellTest, SuccessIsDerivedFromTheOutcomeIfItIsNotAMetric) {
  set_outcome_of_first_run("infrastructure_error");
  const Cell success = cell("success");
  EXPECT_DOUBLE_EQ(*success.estimate, 2.0 / 3);
  EXPECT_EQ(success.na.at("infrastructure_error"), 1u);
}

TEST_F(CellTest, ARunOfUnknownOutcomeIsNeitherASuccessNorAFailure) {
  set_outcome_of_first_run(kUnknownOutcome);
  const Cell success = cell("success");
  EXPECT_DOUBLE_EQ(*success.estimate, 2.0 / 3);
  EXPECT_EQ(success.failures, 1u);
  EXPECT_EQ(success.na.at("not recorded"), 1u);
}

TEST_F(CellTest, WallClockColumnsAreMarked) {
  EXPECT_TRUE(resolve_columns(fixture_.table, {"cycle_time_mean"})[0].wall_clock);
  EXPECT_DOUBLE_EQ(*cell("cycle_time_mean").estimate, 0.25);
  fixture_.erase_metric("cycle_time_mean");
  EXPECT_THROW(resolve_columns(fixture_.table, {"cycle_time_mean"}), Error);
}

TEST_F(CellTest, AnEmptyGroupHasNoEstimate) {
  const ResultTable& table = fixture_.table;
  const Cell none = make_cell(table, {}, *find_metric(table, "success"), {});
  EXPECT_EQ(none.n, 0u);
  EXPECT_FALSE(none.estimate || none.interval || none.deviation);
}

TEST_F(CellTest, AnUnknownColumnSuggestsTheNearest) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "metric 'optimalty': ", {"expected 'optimality'"},
                           [&] { resolve_columns(fixture_.table, {"optimalty"}); }));
}

}  // namespace
}  // namespace slalom
