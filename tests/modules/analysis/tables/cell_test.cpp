// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/cell.h>
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
    return make_cell(fixture_.table, {0, 1, 2, 3}, *find_metric(fixture_.table, id), {}, id);
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
  // t of 2 degrees of freedom at 97.5 % is 4.302653: 0.8 -+ 4.302653 * 0.1 / sqrt(3).
  EXPECT_NEAR(optimality.interval->low, 0.8 - 0.2484138, 1e-6);
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
  const Cell none = make_cell(table, {}, *find_metric(table, "success"), {}, "none");
  EXPECT_EQ(none.n, 0u);
  EXPECT_FALSE(none.estimate || none.interval || none.deviation);
}

TEST_F(CellTest, AnUnknownColumnSuggestsTheNearest) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "metric 'optimalty': ", {"expected 'optimality'"},
                           [&] { resolve_columns(fixture_.table, {"optimalty"}); }));
}

}  // namespace
}  // namespace slalom
