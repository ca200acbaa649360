// SPDX-License-Identifier: BSD-3-Clause
#include "occurrences.h"

#include <slalom/report/figures.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

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
  const std::string svg = scenario_figure(figures, 2);
  EXPECT_EQ(count(svg, "viewBox=\"0 0 410 246\""), 1U)
      << svg;  // two of 200, two of 118, gaps of 10
  EXPECT_EQ(count(svg, "class=\"scene\""), 3U);
  EXPECT_EQ(count(svg, "<svg x=\"210\" y=\"18\""), 1U);
  EXPECT_EQ(count(svg, "<svg x=\"0\" y=\"146\""), 1U);
  EXPECT_EQ(count(svg, ">three</text>"), 1U);
}

}  // namespace
}  // namespace slalom
