#include "result_fixture.h"

#include <slalom/analysis/findings.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// `n` scenarios per bin; in the sparse bin all runs succeed, in the dense one `dense_successes`
/// do.
CrossTable two_bins(int n, int dense_successes) {
  ResultFixture fixture;
  for (int i = 0; i < n; ++i) {
    fixture.add_run(fixture.add_scenario(Value::of(0.05)), "nd", 0.9);
    fixture.add_run(fixture.add_scenario(Value::of(0.35)), "nd", i < dense_successes ? 0.9 : -1);
  }
  return build_cross_tables(fixture.table, parse_bin_specs("density:0,0.1,0.4"), {"success"},
                            {})[0];
}

TEST(Findings, ReportADifferenceIfIntervalsDoNotOverlap) {
  // 30/30: Wilson low is 30 / (30 + z^2) = 0.886; 6/30: [0.095, 0.373].
  EXPECT_EQ(find_difference(two_bins(30, 6), 0)->text,
            "nd: success 1.00 [0.89, 1.00] at density in [0, 0.1), 0.20 [0.10, 0.37] at density in "
            "[0.1, 0.4]");
}

TEST(Findings, ReportNoDifferenceIfIntervalsOverlap) {
  EXPECT_EQ(find_difference(two_bins(30, 28), 0)->text,
            "nd: success: no difference shown between density in [0, 0.1) and in [0.1, 0.4]");
}

TEST(Findings, ReportTooFewRuns) {
  EXPECT_EQ(find_difference(two_bins(9, 0), 0)->text,
            "nd: success: too few runs to compare bins of density");
}

TEST(Findings, CondenseMetricsWithoutADifference) {
  CrossTable table = two_bins(30, 28);
  table.columns.push_back(table.columns[0]);
  for (CrossRow& row : table.rows) row.cells.push_back(row.cells[0]);
  ASSERT_EQ(findings(table).size(), 2u);
  ASSERT_EQ(condensed_findings(table).size(), 1u);
  EXPECT_EQ(condensed_findings(table)[0].text,
            "nd: no difference shown in success, success by density");
}

TEST(Findings, HaveALowFalsePositiveRate) {
  RandomEngine engine(21);
  int differences = 0;
  for (int round = 0; round < 1000; ++round) {
    ResultFixture fixture;
    for (int i = 0; i < 100; ++i) {
      const std::string hash = fixture.add_scenario(Value::of(0.01 * i));
      fixture.add_run(hash, "nd", uniform_real(engine, 0, 1) < 0.5 ? 0.9 : -1);
    }
    const auto table =
        build_cross_tables(fixture.table, parse_bin_specs("density:4"), {"success"}, {})[0];
    differences += find_difference(table, 0)->verdict == Finding::Verdict::Difference ? 1 : 0;
  }
  // Expected 0.6 %; Wilson intervals of 25 runs deviate slightly.
  EXPECT_LE(differences, 15);
}

TEST(Findings, AreEmptyForASingleRow) {
  ResultFixture fixture;
  fixture.add_run(fixture.add_scenario(Value::of(0.1)), "nd", 0.9);
  const auto table = build_cross_tables(fixture.table, {BinSpec{}}, {"success"}, {})[0];
  EXPECT_TRUE(findings(table).empty());
}

}  // namespace
}  // namespace slalom
