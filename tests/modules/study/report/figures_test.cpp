// SPDX-License-Identifier: BSD-3-Clause
#include "occurrences.h"

#include <slalom/report/figures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

constexpr double kMillimeters = 9.0 / 12 * 25.4 / 72;  // of a unit, by default

ProfileTable two_profiles() {
  ProfileTable table;
  table.column.info.name = "Path length";
  table.scenarios = 4;
  table.profiles = {{"a", 0, {{1, 0.5}, {2, 1}}}, {"b & c", 2, {{1, 0.5}, {100, 0.75}}}};
  return table;
}

TEST(Figures, AProfileIsAStepCurveOverTheLogarithmOfTheRatio) {
  const std::string svg = profile_figure(two_profiles());
  // 360 pixels from ratio 1 to 16, from x = 50 on; 240 pixels from fraction 0 at y = 290 upwards.
  EXPECT_EQ(count(svg, "points=\"50.0,290.0 50.0,170.0 140.0,170.0 140.0,50.0 410.0,50.0\""), 1U)
      << svg;
  EXPECT_EQ(count(svg, "points=\"50.0,290.0 50.0,170.0 410.0,170.0\""), 1U) << "cut at 16";
  EXPECT_EQ(count(svg, ">b &amp; c</text>"), 1U);
}

TEST(Figures, ARankDiagramPlacesMethodsAtTheirMeanRanks) {
  MethodRanks ranks;
  ranks.column.info.name = "Success";
  ranks.methods = {"worst", "best", "middle"};
  ranks.test.scenarios = 10;
  ranks.test.mean_ranks = {2.75, 1.25, 2};
  ranks.test.critical_difference = 1;
  ranks.test.groups = {{1, 2}, {2, 0}};
  const std::string svg = rank_figure(ranks);
  // 160 pixels per rank from x = 150 on: best at 190, middle at 310, worst at 430.
  EXPECT_EQ(count(svg, "M190.0 70.0"), 1U) << svg;
  EXPECT_EQ(count(svg, "M310.0 70.0"), 1U);
  EXPECT_EQ(count(svg, "M430.0 70.0"), 1U);
  EXPECT_EQ(count(svg, "M150.0 36.0L310.0 36.0"), 1U) << "the critical difference";
  EXPECT_EQ(count(svg, "stroke-width=\"4.0\""), 2U) << "a bar per group";
  EXPECT_EQ(count(svg, "M186.0 78.0L314.0 78.0"), 1U);
  EXPECT_LT(svg.find("best (1.25)"), svg.find("middle (2.00)"));
}

TEST(Figures, ScenariosAreInRowsWithTheirNames) {
  std::vector<ScenarioFigure> figures;
  for (const char* name : {"one", "two", "three"}) {
    SceneOptions options;
    options.max_pixels = 200;  // 200 x 100
    figures.push_back({Scenario::continuous(name, {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3}), options});
  }
  FigureStyle style;
  style.width = 410 * kMillimeters;
  const std::string svg = scenario_figure(figures, style);
  EXPECT_EQ(count(svg, "viewBox=\"0 0 410 246\""), 1U)
      << svg;  // two of 200, two of 118, gaps of 10
  EXPECT_EQ(count(svg, "class=\"scene\""), 3U);
  EXPECT_EQ(count(svg, "<svg x=\"210\" y=\"18\""), 1U);
  EXPECT_EQ(count(svg, "<svg x=\"0\" y=\"146\""), 1U);
  EXPECT_EQ(count(svg, ">three</text>"), 1U);
}

TEST(Figures, OfScenariosNameMethodsAndReferencePathsOnce) {
  References references;
  references.shortest = {{{1, 3}, {7, 3}}, 6, {6, 6}, "exact", "", 6, std::nullopt};
  std::vector<ScenarioFigure> figures;
  for (const char* name : {"one", "two"}) {
    SceneOptions options;
    options.references = &references;
    options.trajectories = {{"nd", {{1, 3}, {4, 3}}, Outcome::Success, ""},
                            {"a & b", {{1, 3}, {5, 3}}, Outcome::Stuck, ""}};
    figures.push_back({Scenario::continuous(name, {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3}), options});
  }
  const std::string svg = scenario_figure(figures);
  for (const char* name : {"nd", "a &amp; b", "shortest path"})
    EXPECT_EQ(count(svg, ">" + std::string(name) + "</text>"), 1U) << svg;
  EXPECT_EQ(count(svg, "safest path"), 0U);
  EXPECT_EQ(count(svg, " 28,"), 3U) << "a line beside each name";
}

TEST(Figures, LinesOfMethodsDifferInGray) {
  ProfileTable table;
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g"})
    table.profiles.push_back({name, 0, {{1, 0.5}}});
  const std::string svg = profile_figure(table);
  std::set<std::string> dashes;
  const std::string name = "stroke-dasharray=\"";
  for (std::size_t at = svg.find(name); at != std::string::npos; at = svg.find(name, at + 1))
    dashes.insert(svg.substr(at, svg.find('"', at + name.size()) - at));
  EXPECT_EQ(dashes.size(), 6U) << "and one line is solid";
}

/// Runs of "a" with lengths 1, 2, 3, 4 and a failure, and of "b & c" with length 2.
ResultTable lengths() {
  ResultTable runs;
  runs.methods = {"a", "b & c"};
  runs.outcomes = {"success", "stuck"};
  runs.scenario_hashes = {"0123", "4567"};
  runs.scenario_names = {"s", "t"};
  ValueColumn& length = runs.metrics.emplace_back(
      QuantityInfo{"path_length", 1, "Path length", "m", Direction::Down});
  ValueColumn& density =
      runs.descriptors.emplace_back(QuantityInfo{"density", 1, "Density", "-", Direction::None});
  for (const double value : {0.1, 0.3}) density.add_number(value);
  const auto add = [&](std::uint32_t method, std::uint32_t scenario, double value) {
    runs.method.push_back(method);
    runs.scenario.push_back(scenario);
    runs.repetition.push_back(static_cast<std::uint32_t>(runs.size()));
    runs.outcome.push_back(value > 0 ? 0 : 1);
    if (value > 0)
      length.add_number(value);
    else
      length.add_na("stuck");
  };
  for (const double value : {1.0, 2.0, 3.0, 4.0}) add(0, 0, value);
  add(0, 1, -1);
  add(1, 1, 2);
  add_success(runs);
  return runs;
}

TEST(Figures, AreAsWideAsAskedWithTextOfTheSizeAsked) {
  FigureStyle style;
  style.width = 88;  // a column of a paper
  style.font_size = 8;
  style.labels = {{"a", "ND [12]"}};
  for (const std::string& svg :
       {profile_figure(two_profiles(), style), box_figure(lengths(), "path_length", style),
        outcome_figure(build_summary(lengths(), {"success"}, {}), style),
        distribution_figure(lengths(), "path_length", style),
        scatter_figure(lengths(), "density", "path_length", style)}) {
    // 12 units are 8 points, so that 88 mm are 88 / 25.4 * 72 * 12 / 8 units.
    EXPECT_NE(svg.find("viewBox=\"0 0 374 "), std::string::npos) << svg;
    EXPECT_NE(svg.find("width=\"88.00mm\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("font-size=\"12\""), std::string::npos) << svg;
    EXPECT_EQ(count(svg, ">a<") + count(svg, ">a ("), 0U) << svg;
    EXPECT_NE(svg.find("ND [12]"), std::string::npos) << svg;
    const std::string place = "<text x=\"";
    for (std::size_t at = svg.find(place); at != std::string::npos; at = svg.find(place, at + 1))
      EXPECT_LT(std::stod(svg.substr(at + place.size())), 374) << svg;
  }
  style.width.reset();
  EXPECT_NE(profile_figure(two_profiles(), style).find("width=\"393.33pt\""), std::string::npos)
      << "590 units, each of 8 / 12 points";
}

TEST(Figures, BreakLabelsOfBinsThatAreTooLongInANarrowFigure) {
  const ResultTable runs = lengths();
  const auto tables =
      build_cross_tables(runs, {parse_bin_spec("density:0,0.125,0.25,0.375,0.5")}, {"success"}, {});
  FigureStyle style;
  style.width = 60;
  const std::string svg = bins_figure(tables, tables.front().columns.front(), style);
  EXPECT_EQ(count(svg, ">[0.125,</text>"), 1U) << svg;
  EXPECT_EQ(count(svg, ">0.25)</text>"), 1U) << svg;
  EXPECT_EQ(count(svg, ">n = 1</text>"), 1U) << svg;
}

TEST(Figures, AMetricOverBinsIsALineThroughItsEstimates) {
  ResultTable runs = lengths();
  const auto tables =
      build_cross_tables(runs, {parse_bin_spec("density:0,0.2,0.4")}, {"success"}, {});
  const std::string svg = bins_figure(tables, tables.front().columns.front());
  // Two bins, at 140 and 320; the lines of two methods 2.5 pixels to either side; 240 pixels from
  // success 0 at y = 290 upwards. "a" succeeds in 4 of 4 and 0 of 1, "b & c" in 1 of 1.
  EXPECT_EQ(count(svg, "points=\"137.5,50.0 317.5,290.0 \""), 1U) << svg;
  EXPECT_EQ(count(svg, "points=\"322.5,50.0 \""), 1U) << svg;
  EXPECT_EQ(count(svg, ">[0, 0.2)</text>"), 1U);
  EXPECT_EQ(count(svg, "d=\"M3.2 0A"), 2U) << "discs of the first method";
  EXPECT_EQ(count(svg, "d=\"M-2.9 -2.9H"), 1U) << "a square of the second";
  EXPECT_EQ(count(svg, ">n = 4</text>"), 1U);
  EXPECT_EQ(count(svg, ">n = 1</text>"), 1U);
  EXPECT_EQ(count(svg, ">b &amp; c</text>"), 1U);
}

TEST(Figures, AMeanOfSurvivorsIsHollow) {
  ResultTable runs = lengths();
  const auto tables =
      build_cross_tables(runs, {parse_bin_spec("density:0,0.4")}, {"path_length"}, {});
  const std::string svg = bins_figure(tables, tables.front().columns.front());
  // "a" has lengths of 4 of its 5 runs, "b & c" of its only one.
  EXPECT_EQ(count(svg, "fill=\"#ffffff\" stroke="), 1U) << svg;
  EXPECT_EQ(count(svg, "<title>n = 4 of 5</title>"), 1U);
  EXPECT_EQ(count(svg, "<title>n = 1 of 1</title>"), 1U);
  EXPECT_EQ(count(svg, "hollow: "), 1U);
  EXPECT_EQ(count(svg, ">n = 4, 1</text>"), 1U) << "below the bin, in the order of the methods";
}

TEST(Figures, AHistoryIsALineOverTheResults) {
  const std::vector<ResultTable> results = {lengths(), lengths()};
  ComparisonOptions options;
  const std::string svg =
      history_figure(build_history(results, {"success"}, options), "success", {"1-old", "2-new"});
  // "a" succeeds in 4 of 5 runs of both, 48 pixels below the top; "b & c" in its only one.
  EXPECT_EQ(count(svg, "points=\"137.5,98.0 317.5,98.0 \""), 1U) << svg;
  EXPECT_EQ(count(svg, "points=\"142.5,50.0 322.5,50.0 \""), 1U) << svg;
  EXPECT_EQ(count(svg, ">1-old, 2-new</text>"), 1U);
}

TEST(Figures, AMapShowsEstimatesAndTheirNumbers) {
  const BinSpec bins = parse_bin_spec("density:0,0.2,0.4");
  const ResultTable runs = lengths();
  const std::string svg =
      map_figure({build_descriptor_map(runs, "a", bins, bins, "success", {}),
                  build_descriptor_map(runs, "b & c", bins, bins, "success", {})});
  // "a": 4 of 4 where both are low, in the lower row, and 0 of 1 where both are high; "b & c" 1 of
  // 1 there. The other five fields of both have no runs.
  EXPECT_EQ(
      count(svg, "y=\"102.0\" width=\"84\" height=\"40\" fill=\"#008060\" fill-opacity=\"0.55\""),
      1U)
      << svg;
  EXPECT_EQ(count(svg, ">n = 4</text>"), 1U);
  EXPECT_EQ(count(svg, ">n = 1</text>"), 2U);
  EXPECT_EQ(count(svg, ">–</text>"), 5U);
  EXPECT_EQ(count(svg, ">b &amp; c: Success</text>"), 1U);
}

TEST(Figures, AbilitiesStandBesideTheDifficultiesOfScenarios) {
  DifficultyScale scale;
  scale.methods.resize(2);
  scale.methods[0] = {"a", 0.7, 1.0, Interval{0, 2}, {}, {}};
  scale.methods[1].method = "b";
  scale.by_solvers = {2, 0, -2};
  scale.scenarios = {{0, 1, 0, {}, {}}, {1, 1, 0, {}, {}}, {2, 2, -2, {}, {}}};
  const std::string svg = difficulty_figure(scale, {"b", "a"});
  // The axis is from -2.12 to 2.12 in 240 pixels above y = 290: 1 at 290 - 240 * 3.12 / 4.24.
  EXPECT_EQ(count(svg, "cy=\"113.4\" r=\"3.0\" fill=\"" + method_color(1)), 1U) << svg;
  // Two scenarios of difficulty 0, at y = 170, are 0.8 of 360 pixels; one of -2 half of that.
  EXPECT_EQ(count(svg, "L338.0 170.0\""), 1U);
  EXPECT_EQ(count(svg, "L194.0 "), 1U);
  EXPECT_EQ(count(svg, ">b (no finite ability)</text>"), 1U);
}

TEST(Figures, OutcomesAreShares) {
  const std::string svg = outcome_figure(build_summary(lengths(), {"success"}, {}));
  // 360 pixels: 4 of 5 runs of "a" succeed.
  EXPECT_EQ(count(svg, "width=\"288.0\" height=\"16\""), 1U) << svg;
  EXPECT_EQ(count(svg, "width=\"72.0\" height=\"16\""), 1U);
  EXPECT_EQ(count(svg, ">n = 5</text>"), 1U);
}

TEST(Figures, OutcomesLeaveRoomForLongLabels) {
  FigureStyle style;
  style.labels = {{"a", "follow the gap of Sezer and Gokasan [12]"}};
  const std::string svg = outcome_figure(build_summary(lengths(), {"success"}, {}), style);
  const std::size_t label = svg.rfind("<text x=\"", svg.find("Sezer"));
  EXPECT_GT(std::stod(svg.substr(label + 9)), 40 * 6) << "the end of 40 letters in " << svg;
}

TEST(Figures, BoxesAreQuartilesOfTheRunsWithAValue) {
  const std::string svg = box_figure(lengths(), "path_length");
  // The axis is from 1 - 0.09 to 4 + 0.09 m in 240 pixels; quartiles 1.75 and 3.25, median 2.5.
  const auto y = [](double value) { return 290 - 240 * (value - 0.91) / 3.18; };
  char box[80];
  std::snprintf(box, sizeof box, "y=\"%.1f\" width=\"28.0\" height=\"%.1f\"", y(3.25),
                y(1.75) - y(3.25));
  EXPECT_EQ(count(svg, box), 1U) << box << " in " << svg;
  EXPECT_EQ(count(svg, ">a (n = 4 of 5)</text>"), 1U);
  EXPECT_EQ(count(svg, ">2</text>"), 1U);
  EXPECT_THROW(box_figure(lengths(), "path_lenght"), Error);
}

TEST(Figures, ADistributionCountsRunsWithoutAValueAsLarger) {
  const std::string svg = distribution_figure(lengths(), "path_length");
  // 4 of 5 runs of "a" have a length: the curve ends at 0.8, 192 pixels up.
  EXPECT_EQ(count(svg, "410.0,98.0\""), 1U) << svg;
  EXPECT_EQ(count(svg, "410.0,50.0\""), 1U) << "all of b & c";
}

TEST(Figures, ValuesOfAnySizeAreDrawn) {
  for (const auto& [a, b] :
       {std::pair{1e17, 1e17}, {1e17, 1e17 + 16}, {-1e308, 1e308}, {5e-324, 0}}) {
    ResultTable runs = lengths();
    ValueColumn& length = runs.metrics.front();
    length = ValueColumn(length.info());
    for (std::size_t run = 0; run < runs.size(); ++run) length.add_number(run == 0 ? a : b);
    for (const std::string& svg :
         {box_figure(runs, "path_length"), distribution_figure(runs, "path_length"),
          scatter_figure(runs, "path_length", "density")})
      EXPECT_EQ(svg.rfind("</svg>"), svg.size() - 7) << a << " and " << b;
  }
}

TEST(Figures, AScatterHasAPointForEachRunWithBothValues) {
  const std::string svg = scatter_figure(lengths(), "density", "path_length");
  EXPECT_EQ(count(svg, "<circle"), 5U) << svg;
  EXPECT_EQ(count(svg, ">Path length [m]</text>"), 1U);
  EXPECT_EQ(count(svg, ">-0</text>"), 0U);
  EXPECT_THROW(scatter_figure(lengths(), "densty", "path_length"), Error);
}

}  // namespace
}  // namespace slalom
