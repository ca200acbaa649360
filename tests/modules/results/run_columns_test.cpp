#include <slalom/results/run_columns.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

RunRecord record(const std::string& scenario, const std::string& method,
                 const std::string& outcome) {
  RunRecord run;
  run.scenario_hash = scenario;
  run.scenario_name = "name of " + scenario;
  run.method = method;
  run.outcome = outcome;
  return run;
}

TEST(RunColumns, KeepAReasonForEachMissingValue) {
  ValueColumn column({"spl", 1, "SPL", "-", Direction::Up});
  column.add(Value::of(0.5));
  column.add(Value::na("outcome: stuck"));
  column.add_number(std::numeric_limits<double>::quiet_NaN());
  column.add_na("outcome: stuck");
  ASSERT_EQ(column.size(), 4u);
  EXPECT_EQ(column.number(0), 0.5);
  EXPECT_FALSE(column.is_na(0));
  EXPECT_EQ(column.reason(1), "outcome: stuck");
  EXPECT_EQ(column.reason(2), "not a finite number");
  EXPECT_EQ(column.reason(3), "outcome: stuck");
}

TEST(RunColumns, SayWhatTheTableSays) {
  ResultTable table;
  table.quantities["spl"] = {"spl", 2, "SPL", "-", Direction::Up};
  table.quantities["density"] = {"density", 1, "Density", "-", Direction::None};
  table.scenarios["b"] = {"b", "name of b", {{"density", {1, Value::of(0.25)}}}};
  table.scenarios["unused"] = {"unused", "u", {{"density", {1, Value::of(0.75)}}}};
  table.runs = {record("b", "z", "success"), record("b", "a", "stuck"), record("c", "z", "")};
  table.runs[0].metrics["spl"] = {2, Value::of(0.9)};
  table.runs[1].metrics["spl"] = {1, Value::of(0.8)};
  table.timings = {{1, {{"cycle_time_mean", 2.5}}}};
  const RunColumns columns = to_columns(table);
  EXPECT_EQ(columns.methods, (std::vector<std::string>{"a", "z"}));
  EXPECT_EQ(columns.method, (std::vector<std::uint32_t>{1, 0, 1}));
  const ValueColumn& spl = *find_metric(columns, "spl");
  EXPECT_EQ(spl.number(0), 0.9);
  EXPECT_EQ(spl.reason(1), "other version 1");
  EXPECT_EQ(spl.reason(2), "not recorded");
  const ValueColumn& density = *find_descriptor(columns, "density");
  ASSERT_EQ(density.size(), 3u);  // b, c and the one that was not driven
  EXPECT_EQ(density.number(0), 0.25);
  EXPECT_EQ(density.reason(1), "not computed");
  EXPECT_EQ(density.number(2), 0.75);
  const ValueColumn& cycle = *find_metric(columns, "cycle_time_mean");
  EXPECT_TRUE(cycle.wall_clock);
  EXPECT_EQ(cycle.reason(1), "not recorded");
  EXPECT_EQ(run_id(columns, 1), run_id(table.runs[1]));
}

TEST(RunColumns, SuccessFollowsFromTheOutcome) {
  ResultTable table;
  table.runs = {record("a", "m", "success"), record("b", "m", "collision"),
                record("c", "m", "unsolvable_scenario")};
  const RunColumns columns = to_columns(table);
  const ValueColumn& success = *find_metric(columns, "success");
  EXPECT_TRUE(success.rate);
  EXPECT_EQ(success.number(0), 1);
  EXPECT_EQ(success.number(1), 0);
  EXPECT_EQ(success.reason(2), "unsolvable_scenario");
  EXPECT_TRUE(is_failure("stuck"));
  for (const char* outcome :
       {"success", "unsolvable_scenario", "infrastructure_error", kUnknownOutcome})
    EXPECT_FALSE(is_failure(outcome));
}

}  // namespace
}  // namespace slalom
