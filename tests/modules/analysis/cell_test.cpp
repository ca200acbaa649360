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
    const RunColumns columns = to_columns(fixture_.table);
    return make_cell(columns, {0, 1, 2, 3}, *find_metric(columns, id), {}, id);
  }

  ResultFixture fixture_;
};

TEST_F(CellTest, CountsWhatIsMissingByReasonAndNeverInventsValues) {
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

TEST_F(CellTest, SuccessFollowsFromTheOutcomeWhereItIsNoMetric) {
  for (RunRecord& run : fixture_.table.runs) run.metrics.erase("success");
  fixture_.table.runs[0].outcome = "infrastructure_error";
  const Cell success = cell("success");
  EXPECT_DOUBLE_EQ(*success.estimate, 2.0 / 3);
  EXPECT_EQ(success.na.at("infrastructure_error"), 1u);
}

TEST_F(CellTest, ValuesOfAnotherVersionAreNotMixedIn) {
  fixture_.table.runs[0].metrics["optimality"].version = 1;
  EXPECT_EQ(cell("optimality").na.at("other version 1"), 1u);
}

TEST_F(CellTest, WallClockFiguresAreMarked) {
  EXPECT_TRUE(resolve_columns(fixture_.table, {"cycle_time_mean"})[0].wall_clock);
  EXPECT_DOUBLE_EQ(*cell("cycle_time_mean").estimate, 0.25);
  fixture_.table.timings.clear();
  EXPECT_THROW(resolve_columns(fixture_.table, {"cycle_time_mean"}), Error);
}

TEST_F(CellTest, AnEmptyGroupHasNoEstimate) {
  const RunColumns columns = to_columns(fixture_.table);
  const Cell none = make_cell(columns, {}, *find_metric(columns, "success"), {}, "none");
  EXPECT_EQ(none.n, 0u);
  EXPECT_FALSE(none.estimate || none.interval || none.deviation);
}

TEST_F(CellTest, AnUnknownColumnNamesTheNearest) {
  try {
    resolve_columns(fixture_.table, {"optimalty"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 2);
    EXPECT_NE(std::string(error.what()).find("expected 'optimality'"), std::string::npos);
  }
}

}  // namespace
}  // namespace slalom
