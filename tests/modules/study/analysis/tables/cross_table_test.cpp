// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(CrossTable, AgreesWithManualCounts) {
  ResultFixture fixture;
  const std::string sparse = fixture.add_scenario(Value::of(0.05));
  const std::string edge = fixture.add_scenario(Value::of(0.1));
  const std::string dense = fixture.add_scenario(Value::of(0.2));
  fixture.add_run(sparse, "nd", 0.9);
  fixture.add_run(edge, "nd", 0.7);
  fixture.add_run(dense, "nd", -1);
  fixture.add_run(sparse, "vff", 0.1);
  const auto tables = build_cross_tables(fixture.table, parse_bin_specs("density:0,0.1,0.2"),
                                         {"success", "optimality"}, {});
  ASSERT_EQ(tables.size(), 2u);
  const CrossTable& nd = tables[0];
  EXPECT_EQ(nd.title, "nd by density");
  EXPECT_EQ(nd.rows[0].run_ids, std::vector<std::string>{run_id(fixture.table, 0)});
  EXPECT_DOUBLE_EQ(*nd.rows[0].cells[1].estimate, 0.9);
  EXPECT_EQ(nd.rows[1].runs, (std::vector<std::size_t>{1, 2}));
  EXPECT_DOUBLE_EQ(*nd.rows[1].cells[0].estimate, 0.5);
  EXPECT_DOUBLE_EQ(*nd.rows[1].cells[1].estimate, 0.7);
  EXPECT_EQ(nd.rows[1].cells[1].na.at("collision"), 1u);
  EXPECT_TRUE(nd.notes.empty());
  EXPECT_EQ(tables[1].rows[1].cells[0].n, 0u);
}

TEST(CrossTable, ReportsExcludedRuns) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.05)), "nd", 0.9);
  fixture.add_run(fixture.add_scenario(Value::of(0.9)), "nd", 0.9);
  fixture.add_run(fixture.add_scenario(Value::of(-0.1)), "nd", 0.9);
  fixture.add_run(fixture.add_scenario(Value::na("too big")), "nd", 0.9);
  const auto table =
      build_cross_tables(fixture.table, parse_bin_specs("density:0,0.1"), {"success"}, {})[0];
  EXPECT_EQ(table.rows[0].runs.size(), 1u);
  EXPECT_EQ(table.outside, 2u);
  EXPECT_EQ(table.undescribed, 1u);
  ASSERT_EQ(table.notes.size(), 2u);
  EXPECT_EQ(table.notes[0], "2 runs left out: density outside the bins");
  EXPECT_EQ(table.notes[1], "1 run left out: scenario has no value of density");
}

TEST(CrossTable, AllPutsEveryRunIntoOneRow) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::na("too big")), "nd", 0.9);
  const auto table = build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, {})[0];
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0].bin.label(), "all");
  EXPECT_EQ(table.rows[0].cells[0].n, 1u);
}

TEST(CrossTable, ACellDoesNotDependOnTheOthers) {
  ResultFixture fixture;
  RandomEngine engine(2);
  for (int i = 0; i < 9; ++i) {
    const std::string hash = fixture.add_scenario(Value::of(0.1));
    for (int r = 0; r < 3; ++r) fixture.add_run(hash, "nd", uniform_real(engine, 0, 1), r);
  }
  const auto specs = parse_bin_specs("density:0,1");
  const auto alone = build_cross_tables(fixture.table, specs, {"optimality"}, {})[0];
  fixture.add_run(fixture.table.scenario_hashes[0], "vff", 0.5);
  const auto both = build_cross_tables(fixture.table, specs, {"success", "optimality"}, {})[0];
  EXPECT_EQ(alone.rows[0].cells[0].interval->low, both.rows[0].cells[1].interval->low);
  EXPECT_EQ(alone.rows[0].cells[0].interval->high, both.rows[0].cells[1].interval->high);
}

TEST(CrossTable, AnUnknownMethodSuggestsTheNearest) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "follow_the_gap", 0.9);
  EXPECT_TRUE(throws_error(
      ErrorKind::Usage, "method", {"'follow_gap'", "expected 'follow_the_gap'"},
      [&] { build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, {}, "follow_gap"); }));
}

TEST(CrossTable, RejectsAnInvalidConfidence) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "nd", 0.9);
  for (const double confidence : {0.0, 1.0, -1.0, 95.0}) {
    AnalysisOptions options;
    options.confidence = confidence;
    EXPECT_THROW(build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, options), Error);
  }
}

TEST(CrossTable, NoRunsGiveNoTables) {
  ResultFixture fixture;
  EXPECT_TRUE(build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, {}).empty());
}

}  // namespace
}  // namespace slalom
