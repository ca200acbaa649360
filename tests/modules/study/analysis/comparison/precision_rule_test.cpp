// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/precision_rule.h>
#include <slalom/core/error.h>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace slalom {
namespace {

TEST(PrecisionRule, IsParsedWithAndWithoutBins) {
  const PrecisionRule rule = parse_precision_rule("interval(success) < 0.05 in density:0,0.1,0.4");
  EXPECT_EQ(rule.metric, "success");
  EXPECT_EQ(rule.width, 0.05);
  EXPECT_EQ(rule.rows.descriptor, "density");
  EXPECT_EQ(rule.rows.edges, (std::vector<double>{0, 0.1, 0.4}));
  EXPECT_EQ(parse_precision_rule(" interval( spl )<0.2 ").rows.kind, BinSpec::Kind::All);
}

TEST(PrecisionRule, ThatIsMalformedIsRejectedWithTheExpectedForm) {
  for (const char* text : {"", "success < 0.05", "interval(success) > 0.05", "interval() < 0.1",
                           "interval(success) < x", "interval(success) < -1",
                           "interval(success) < 0", "interval(success) < 0.1 in"}) {
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "--until", {"interval(METRIC) < WIDTH"}, [&] {
      parse_precision_rule(text);
    })) << text;
  }
}

/// Campaigns whose method succeeds at `rate`, computed from the binomial distribution: looks at 10
/// runs and half as many more each time, until the interval at `confidence_of` look is narrower
/// than `width`.
struct Stopped {
  double coverage = 0, mean_runs = 0;
};

Stopped stop_at_width(double rate, double width,
                      const std::function<double(int look)>& confidence_of) {
  Stopped stopped;
  std::vector<double> open = {1};  // by successes, of the campaigns that go on
  std::size_t runs = 0;
  for (int look = 1; std::accumulate(open.begin(), open.end(), 0.0) > 1e-9; ++look) {
    const std::size_t batch = runs == 0 ? 10 : (runs + 1) / 2;
    const boost::math::binomial more(static_cast<double>(batch), rate);
    std::vector<double> next(runs + batch + 1, 0.0);
    for (std::size_t k = 0; k <= batch; ++k) {
      const double chance = pdf(more, static_cast<double>(k));
      for (std::size_t i = 0; i < open.size(); ++i) next[i + k] += open[i] * chance;
    }
    runs += batch;
    const double n = static_cast<double>(runs);
    for (std::size_t i = 0; i <= runs; ++i) {
      const Interval interval = wilson_interval(static_cast<double>(i) / n, n, confidence_of(look));
      if (interval.high - interval.low >= width) continue;
      if (interval.low <= rate && rate <= interval.high) stopped.coverage += next[i];
      stopped.mean_runs += next[i] * n;
      next[i] = 0;
    }
    open = std::move(next);
  }
  return stopped;
}

TEST(LookConfidence, KeepsTheCoverageOfRatesAndSavesSixtyPercentOfTheRunsOfABonferroniBound) {
  EXPECT_DOUBLE_EQ(look_confidence(0.95), 0.97);
  const auto chosen = [](int) { return look_confidence(0.95); };
  const auto bonferroni = [](int look) { return 1 - 0.05 / (look * (look + 1)); };
  for (const double width : {0.2, 0.1}) {
    double runs = 0, bonferroni_runs = 0;
    for (const double rate : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95}) {
      const Stopped stopped = stop_at_width(rate, width, chosen);
      EXPECT_GE(stopped.coverage, 0.95) << rate << " to " << width;
      runs += stopped.mean_runs;
      bonferroni_runs += stop_at_width(rate, width, bonferroni).mean_runs;
    }
    EXPECT_LE(runs, 0.4 * bonferroni_runs) << width;
  }
}

/// 40 successes of 40 at density 0.05, and one of two at 0.2.
ResultFixture uneven() {
  ResultFixture fixture;
  for (int i = 0; i < 40; ++i) fixture.add_run(fixture.add_scenario(Value::of(0.05)), "nd", 1);
  for (const double optimality : {1.0, -1.0})
    fixture.add_run(fixture.add_scenario(Value::of(0.2)), "nd", optimality);
  return fixture;
}

TEST(PrecisionCells, AreReachedIfTheIntervalOfTheLookIsNarrowEnough) {
  const ResultFixture fixture = uneven();
  const ResultTable runs = fixture.table;
  const PrecisionRule rule = parse_precision_rule("interval(success) < 0.15 in density:0,0.1,0.3");
  const auto cells = precision_cells(runs, rule, {});
  ASSERT_EQ(cells.size(), 2u);
  // Wilson's interval of 40 of 40 at 97 %: [n / (n + z^2), 1] with z = 2.1701: width 0.1053.
  EXPECT_NEAR(cells[0].cell.interval->high - cells[0].cell.interval->low, 4.7093 / 44.7093, 1e-4);
  EXPECT_TRUE(cells[0].reached);
  EXPECT_FALSE(cells[1].reached);
  AnalysisOptions strict;  // at 99.94 %: z = 3.4320, width 0.2275
  strict.confidence = 0.999;
  EXPECT_FALSE(precision_cells(runs, rule, strict)[0].reached);
}

TEST(PrecisionCells, WithoutRunsAreNotReached) {
  const ResultFixture fixture = uneven();
  const auto cells = precision_cells(
      fixture.table, parse_precision_rule("interval(success) < 2 in density:0.5,1"), {});
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_FALSE(cells[0].reached);
}

TEST(PrecisionCells, AsTextShowWhichAreReached) {
  const ResultFixture fixture = uneven();
  const PrecisionRule rule = parse_precision_rule("interval(success) < 0.15 in density:0,0.1,0.3");
  const std::string text = render_precision_text(rule, precision_cells(fixture.table, rule, {}));
  EXPECT_NE(text.find("density"), std::string::npos);
  EXPECT_NE(text.find("yes"), std::string::npos);
  EXPECT_NE(text.find("no"), std::string::npos);
}

TEST(WithEdges, OfCountedBinsAreTheSameBins) {
  const ResultFixture fixture = uneven();
  const ResultTable runs = fixture.table;
  const auto bins = make_bins(parse_bin_spec("density:3"), runs);
  const auto again = make_bins(with_edges("density", bins), runs);
  ASSERT_EQ(again.size(), bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) EXPECT_EQ(again[i].label(), bins[i].label());
}

}  // namespace
}  // namespace slalom
