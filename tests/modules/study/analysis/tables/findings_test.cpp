// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/findings.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// 25 scenarios per bin of density, of which so many succeed.
std::vector<CrossTable> tables_of(const std::vector<int>& successes,
                                  const std::vector<std::string>& columns) {
  ResultFixture fixture;
  for (int i = 0; i < 25; ++i)
    for (std::size_t bin = 0; bin < successes.size(); ++bin)
      fixture.add_run(fixture.add_scenario(Value::of(0.05 + 0.1 * static_cast<double>(bin))), "nd",
                      i < successes[bin] ? 0.9 : -1);
  return build_cross_tables(fixture.table, parse_bin_specs("density:0,0.1,0.2,0.3,0.4"), columns,
                            {});
}

TEST(Findings, ReportATrendOverAllBins) {
  // The intervals of the outer bins overlap: [0.87, 1.00] and [0.57, 0.89]. z = -11 / sqrt(15.05).
  const CrossTable table = tables_of({25, 23, 19, 19}, {"success"})[0];
  EXPECT_EQ(findings(table)[0].text,
            "nd: success falls with density, from 1.00 [0.87, 1.00] in [0, 0.1) to 0.76 [0.57, "
            "0.89] in [0.3, 0.4], p = 0.0046 (Cochran-Armitage, Holm)");
}

TEST(Findings, LeaveOutEndsThatContradictTheTrend) {
  // 47 of 100: T = 2 + 2 * 25 + 3 * 10 - 0.47 * 150 = 11.5, variance 0.47 * 0.53 * 125, z = 2.061.
  const CrossTable table = tables_of({10, 2, 25, 10}, {"success"})[0];
  EXPECT_EQ(findings(table)[0].text,
            "nd: success rises with density, p = 0.0393 (Cochran-Armitage, Holm)");
}

TEST(Findings, SayOfHowManyRunsTheyAreWhereMoreThanATenthHaveNoValue) {
  CrossTable table = tables_of({25, 23, 19, 19}, {"success"})[0];
  for (CrossRow& row : table.rows) row.cells[0].n += 5;
  EXPECT_NE(findings(table)[0].text.find("; of the 100 of 120 runs with a value"),
            std::string::npos);
}

TEST(Findings, OfOneAnalysisAreOneFamilyOfTests) {
  // Success, twice, with path lengths that do not vary and do not count.
  const CrossTable table = tables_of({25, 23, 19, 19}, {"success", "path_length", "success"})[0];
  EXPECT_EQ(table.trends[1]->test.kind, TrendTest::Kind::NoVariation);
  EXPECT_EQ(table.trends[0]->adjusted_p, 2 * table.trends[0]->test.p);
  EXPECT_EQ(table.trends[2]->adjusted_p, 2 * table.trends[2]->test.p);
}

TEST(Findings, CondenseMetricsWithoutATrend) {
  const CrossTable table = tables_of({20, 21, 20, 21}, {"success", "path_length"})[0];
  ASSERT_EQ(findings(table).size(), 2u);
  ASSERT_EQ(condensed_findings(table).size(), 1u);
  EXPECT_EQ(condensed_findings(table)[0].text,
            "nd: no trend shown in success, path_length by density");
}

TEST(Findings, ReportTooFewRuns) {
  ResultFixture fixture;
  for (int i = 0; i < 19; ++i)
    fixture.add_run(fixture.add_scenario(Value::of(0.02 * i)), "nd", i < 9 ? 0.9 : -1);
  const CrossTable table =
      build_cross_tables(fixture.table, parse_bin_specs("density:2"), {"success"}, {})[0];
  EXPECT_EQ(findings(table)[0].text, "nd: too few runs for a trend of success by density");
}

TEST(Findings, LeaveOutMeasuredTimes) {
  EXPECT_TRUE(findings(tables_of({25, 23, 19, 19}, {"cycle_time_mean"})[0]).empty());
}

TEST(Findings, HaveTheirFalsePositiveRate) {
  RandomEngine engine(21);
  int shown = 0;
  for (int round = 0; round < 1000; ++round) {
    ResultFixture fixture;
    for (int i = 0; i < 100; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.01 * i));
      fixture.add_run(hash, "nd", uniform_real(engine, 0, 1) < 0.5 ? 0.9 : -1);
    }
    const auto table =
        build_cross_tables(fixture.table, parse_bin_specs("density:4"), {"success"}, {})[0];
    shown += findings(table)[0].verdict == Finding::Verdict::Trend ? 1 : 0;
  }
  // Binomial: 50 with a standard deviation of 6.9; four of them on both sides.
  EXPECT_GT(shown, 22);
  EXPECT_LT(shown, 78);
}

TEST(Findings, AreEmptyForASingleRow) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "nd", 0.9);
  const auto table = build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, {})[0];
  EXPECT_TRUE(findings(table).empty());
}

}  // namespace
}  // namespace slalom
