// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/table_builder.h>

#include <gtest/gtest.h>

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

TEST(TableBuilder, SortsRecordsIntoColumns) {
  TableBuilder builder({{"density", 2, "Density", "-", Direction::None}},
                       {{"spl", 1, "SPL", "-", Direction::Up}});
  RunRecord first = record("b", "z", "success");
  first.metrics["spl"] = {1, Value::of(0.9)};
  first.seed = 7;
  builder.add_run(first, {1.5, {}});
  builder.add_run(record("b", "a", "stuck"), {0, {{"cycle_time_mean", 2.5}}});
  builder.add_run(record("c", "z", kUnknownOutcome), {});
  builder.add_scenario({"b", "name of b", {{"density", {2, Value::of(0.25)}}}});
  builder.add_scenario({"d", "name of d", {{"density", {1, Value::of(0.75)}}}});
  const ResultTable table = builder.finish();
  EXPECT_EQ(table.methods, (std::vector<std::string>{"a", "z"}));
  EXPECT_EQ(table.method, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_EQ(table.scenario_hashes, (std::vector<std::string>{"b", "c", "d"}));
  const ValueColumn& spl = *find_metric(table, "spl");
  EXPECT_EQ(spl.reason(0), "not computed");
  EXPECT_EQ(spl.number(1), 0.9);
  const ValueColumn& density = *find_descriptor(table, "density");
  ASSERT_EQ(density.size(), 3u);
  EXPECT_EQ(density.number(0), 0.25);
  EXPECT_EQ(density.reason(1), "not recorded");
  EXPECT_EQ(density.reason(2), "other version 1");
  const ValueColumn& cycle = *find_metric(table, "cycle_time_mean");
  EXPECT_TRUE(cycle.wall_clock);
  EXPECT_EQ(cycle.number(0), 2.5);
  EXPECT_EQ(cycle.reason(1), "not recorded");
  EXPECT_EQ(cycle.reason(2), "not recorded");
  const ValueColumn& success = *find_metric(table, "success");
  EXPECT_EQ(success.number(0), 0);
  EXPECT_EQ(success.number(1), 1);
  EXPECT_EQ(success.reason(2), "not recorded");
  EXPECT_EQ(table.details[1].seed, 7u);
  EXPECT_EQ(table.details[1].wall_seconds, 1.5);
  EXPECT_EQ(run_id(table, 1), run_id(first));
}

TEST(TableBuilder, GivesAnEmptyTableWithoutRecords) {
  TableBuilder builder({}, {success_info()});
  const ResultTable table = builder.finish();
  EXPECT_EQ(table.size(), 0u);
  EXPECT_TRUE(table.metrics.at(0).info().is_rate());
}

}  // namespace
}  // namespace slalom
