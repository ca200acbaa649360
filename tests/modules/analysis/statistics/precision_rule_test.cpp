#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/precision_rule.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

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

TEST(LookConfidence, SpendsAtMostTheTotalErrorProbability) {
  EXPECT_DOUBLE_EQ(look_confidence(0.95, 1), 0.975);
  double spent = 0;
  for (int look = 1; look <= 10000; ++look) {
    EXPECT_GT(look_confidence(0.95, look),
              look_confidence(0.95, look - 1 > 0 ? look - 1 : 1) - 1e-15);
    spent += 1 - look_confidence(0.95, look);
  }
  EXPECT_LT(spent, 0.05);
  EXPECT_GT(spent, 0.05 * 0.999);
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
  const auto cells = precision_cells(runs, rule, {}, 1);
  ASSERT_EQ(cells.size(), 2u);
  // Wilson's interval of 40 of 40 at 97.5 %: [n / (n + z^2), 1] with z = 2.2414: width 0.1116.
  EXPECT_NEAR(cells[0].cell.interval->high - cells[0].cell.interval->low, 5.0239 / 45.0239, 1e-4);
  EXPECT_TRUE(cells[0].reached);
  EXPECT_FALSE(cells[1].reached);
  // At the tenth look: 1 - 0.05 / 110, z = 3.5071, width 0.2352.
  EXPECT_FALSE(precision_cells(runs, rule, {}, 10)[0].reached);
}

TEST(PrecisionCells, WithoutRunsAreNotReached) {
  const ResultFixture fixture = uneven();
  const auto cells = precision_cells(
      fixture.table, parse_precision_rule("interval(success) < 2 in density:0.5,1"), {}, 1);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_FALSE(cells[0].reached);
}

TEST(PrecisionCells, AsTextShowWhichAreReached) {
  const ResultFixture fixture = uneven();
  const PrecisionRule rule = parse_precision_rule("interval(success) < 0.15 in density:0,0.1,0.3");
  const std::string text = render_precision_text(rule, precision_cells(fixture.table, rule, {}, 1));
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
