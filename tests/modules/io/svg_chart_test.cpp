#include "svg_chart.h"

#include <gtest/gtest.h>

#include <regex>

namespace slalom {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// The drawing commands of the path with this title.
std::string path_of(const std::string& svg, const std::string& label) {
  std::smatch found;
  const std::regex path("<path d=\"([^\"]*)\"[^>]*><title>" + label + "</title>");
  return std::regex_search(svg, found, path) ? found[1].str() : "none";
}

TEST(StepChart, KeepsEachValueUntilTheNextPointAndTheLastToTheBorder) {
  const std::string svg =
      step_chart({"time", "share", 0, 10}, {{"a", "#000000", {{0, 0}, {5, 0.5}}}});
  // The plot spans 52 .. 626 and, from 1 down to 0, 12 .. 256 pixels: 5 lies at 339, 0.5 at 134.
  EXPECT_EQ(path_of(svg, "a"), "M52.0 256.0H339.0V134.0H626.0");
}

TEST(StepChart, OnALogarithmicAxisPutsTheGeometricMeanInTheMiddle) {
  const std::string svg =
      step_chart({"ratio", "share", 1, 16, true}, {{"a", "#000000", {{1, 0}, {4, 1}}}});
  EXPECT_EQ(path_of(svg, "a"), "M52.0 256.0H339.0V12.0H626.0");
}

TEST(StepChart, EscapesLabelsAndNamesEveryLine) {
  const std::string svg =
      step_chart({"<x>", "y", 0, 1}, {{"a & b", "#111111", {{0, 1}}}, {"c", "#222222", {}}});
  EXPECT_EQ(count(svg, "a &amp; b"), 2u);  // title and legend
  EXPECT_EQ(count(svg, "#222222"), 1u);    // no points: the legend alone
  EXPECT_EQ(count(svg, "<x>"), 0u);
}

TEST(StepChart, OfAnEmptyRangeStillIsAPicture) {
  const std::string svg = step_chart({"x", "y", 3, 3}, {{"a", "#000000", {{3, 0.5}}}});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(RankDiagram, ShowsEveryMethodAtItsMeanRankAndABarPerGroup) {
  MethodRanks ranks;
  ranks.methods = {"nd", "gap", "vff"};
  ranks.test.mean_ranks = {2, 1, 3};
  ranks.test.critical_difference = 1;
  ranks.test.groups = {{1, 0}, {0, 2}};
  const std::string svg = rank_diagram(ranks, {"#1", "#2", "#3"});
  // Ranks 1 .. 3 span 40 .. 420 pixels.
  EXPECT_EQ(count(svg, "<circle cx=\"40.0\""), 1u);
  EXPECT_EQ(count(svg, "<circle cx=\"230.0\""), 1u);
  EXPECT_EQ(count(svg, "<circle cx=\"420.0\""), 1u);
  EXPECT_EQ(count(svg, "class=\"bar\""), 3u);  // the critical difference and two groups
  EXPECT_LT(svg.find(">gap  1.00<"), svg.find(">nd  2.00<"));
}

}  // namespace
}  // namespace slalom
