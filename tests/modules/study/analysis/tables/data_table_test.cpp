// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/data_table.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace slalom {
namespace {

std::size_t index_of(const DataTable& table, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  EXPECT_NE(found, table.columns.end()) << column;
  return static_cast<std::size_t>(found - table.columns.begin());
}

Field field(const DataTable& table, std::size_t row, const std::string& column) {
  return table.at(row, index_of(table, column));
}

/// A success of 0.5 and a collision in one scenario of density 0.2.
ResultFixture two_runs() {
  ResultFixture fixture;
  const std::string hash = fixture.add_scenario(Value::of(0.2));
  fixture.add_run(hash, "nd", 0.5);
  fixture.add_run(hash, "nd", -1, 1);
  return fixture;
}

TEST(DataTable, HasOneRowPerRunWithMetricsReasonsAndDescriptors) {
  const ResultFixture fixture = two_runs();
  const DataTable runs = runs_table(fixture.table);
  ASSERT_EQ(runs.rows, 2u);
  EXPECT_EQ(field(runs, 0, "method"), Field{std::string("nd")});
  EXPECT_EQ(field(runs, 1, "repetition"), Field{std::int64_t{1}});
  EXPECT_EQ(field(runs, 0, "optimality"), Field{0.5});
  EXPECT_EQ(field(runs, 1, "optimality"), Field{});
  EXPECT_EQ(field(runs, 1, "not_available"), Field{std::string("optimality: collision")});
  EXPECT_EQ(field(runs, 1, "scenario.density"), Field{0.2});
}

TEST(DataTable, KeepsSeedsThatOnlyUnsignedNumbersHold) {
  ResultFixture fixture = two_runs();
  fixture.table.details[1].seed = 18446744073709551557U;  // 2^64 - 59
  const DataTable runs = runs_table(fixture.table);
  EXPECT_NE(render_csv(runs).find(",18446744073709551557,"), std::string::npos);
  const auto json = nlohmann::json::parse(render_json(runs));
  EXPECT_EQ(json["rows"][1][index_of(runs, "seed")], 18446744073709551557U);
}

TEST(DataTable, LeavesDetailsThatWereNotReadEmpty) {
  ResultFixture fixture = two_runs();
  fixture.table.details.clear();
  EXPECT_EQ(field(runs_table(fixture.table), 0, "seed"), Field{});
  EXPECT_EQ(timings_table(fixture.table).rows, 0u);
}

TEST(DataTable, KeepsWallClockMeasurementsInASeparateTable) {
  const ResultFixture fixture = two_runs();
  const DataTable runs = runs_table(fixture.table), timings = timings_table(fixture.table);
  for (const std::string& column : runs.columns)
    EXPECT_EQ(column.find("cycle_time"), std::string::npos) << column;
  EXPECT_EQ(field(timings, 0, "cycle_time_mean_ms"), Field{0.25});
  EXPECT_EQ(field(timings, 0, "run"), field(runs, 0, "run"));
}

TEST(DataTable, HasOneRowPerScenario) {
  ResultFixture fixture;
  fixture.add_scenario(Value::of(0.2));
  fixture.add_scenario(Value::na("too small"));
  const DataTable scenarios = scenarios_table(fixture.table);
  ASSERT_EQ(scenarios.rows, 2u);
  EXPECT_EQ(field(scenarios, 0, "density"), Field{0.2});
  EXPECT_EQ(field(scenarios, 1, "density"), Field{});
}

TEST(DataTable, OfASummaryCountsOutcomesAndGivesIntervals) {
  const ResultFixture fixture = two_runs();
  const SummaryTable summary = build_summary(fixture.table, {"success", "optimality"}, {});
  const DataTable data = summary_data(summary);
  ASSERT_EQ(data.rows, 1u);
  EXPECT_EQ(field(data, 0, "outcome.collision"), Field{std::int64_t{1}});
  EXPECT_EQ(field(data, 0, "success"), Field{0.5});
  EXPECT_EQ(field(data, 0, "success.low"), Field{summary.methods[0].cells[0].interval->low});
  EXPECT_EQ(field(data, 0, "optimality.n"), Field{std::int64_t{1}});  // its mean is of one value
  EXPECT_EQ(field(data, 0, "optimality.na"), Field{std::int64_t{1}});
}

TEST(DataTable, OfACrossTableHasOneRowPerBin) {
  const ResultFixture fixture = two_runs();
  const auto tables =
      build_cross_tables(fixture.table, {parse_bin_spec("density:0,0.1,0.3")}, {"success"}, {});
  const DataTable data = cross_data(tables.at(0));
  EXPECT_EQ(data.name, "nd_by_density");
  ASSERT_EQ(data.rows, 2u);
  EXPECT_EQ(field(data, 0, "runs"), Field{std::int64_t{0}});
  EXPECT_EQ(field(data, 0, "success"), Field{});
  EXPECT_EQ(field(data, 1, "bin_high"), Field{0.3});
  EXPECT_EQ(field(data, 1, "success"), Field{0.5});
}

/// A table whose fields contain separators and quotes.
DataTable awkward() {
  return {"t", "T", {"a", "b,c"}, 2, [](std::size_t row, std::size_t column) -> Field {
            if (row == 0) return column == 0 ? Field{0.1} : Field{std::string("x \"y\", z\n")};
            return column == 0 ? Field{std::int64_t{1} << 62} : Field{};
          }};
}

TEST(DataTable, AsCsvQuotesSpecialCharacters) {
  EXPECT_EQ(render_csv(awkward()), "a,\"b,c\"\n0.1,\"x \"\"y\"\", z\n\"\n4611686018427387904,\n");
}

TEST(DataTable, AsJsonRoundTrips) {
  const auto json = nlohmann::json::parse(render_json(awkward()));
  EXPECT_EQ(json["columns"][1], "b,c");
  EXPECT_EQ(json["rows"][0][0], 0.1);
  EXPECT_EQ(json["rows"][0][1], "x \"y\", z\n");
  EXPECT_EQ(json["rows"][1][0], std::int64_t{1} << 62);
  EXPECT_TRUE(json["rows"][1][1].is_null());
}

TEST(DataTable, OfNoRunsHasNoRows) {
  const ResultTable nothing;
  EXPECT_EQ(runs_table(nothing).rows, 0u);
  EXPECT_EQ(timings_table(nothing).rows, 0u);
  EXPECT_EQ(manifest_table(nothing).rows, 0u);
}

}  // namespace
}  // namespace slalom
