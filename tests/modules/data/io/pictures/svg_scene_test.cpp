// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"
#include "occurrences.h"

#include <slalom/io/svg_scene.h>

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

TEST(SvgScene, PrimitivesAreDrawnToScaleWithYUp) {
  Primitives obstacles;
  obstacles.discs.push_back({{2, 1}, 0.5});
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, obstacles, {1, 3, 0}, {7, 3});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter: 400 x 200
  const std::string svg = render_svg(scenario, options);
  EXPECT_NE(svg.find("viewBox=\"0 0 400 200\""), std::string::npos);
  EXPECT_NE(svg.find("<circle cx=\"100.0\" cy=\"150.0\" r=\"25.0\"/>"), std::string::npos);
}

TEST(SvgScene, EveryRepresentationAndAllPathsAreDrawn) {
  References references;
  references.shortest = ShortestPath{{{1, 1}, {9, 9}}, 11, {11, 11}, "exact", ""};
  references.safest = SafestPath{{{1, 1}, {2, 7}, {9, 9}}, 0.5};
  SceneOptions options;
  options.references = &references;
  options.trajectories = {{"good", {{1, 1}, {3, 3}, {9, 9}}, Outcome::Success, ""},
                          {"bad", {{1, 1}, {5, 5}}, Outcome::Collision, ""}};
  for (const Representation representation :
       {Representation::Continuous, Representation::Grid, Representation::Points}) {
    const std::string svg = render_svg(sample_as(representation), options);
    EXPECT_EQ(count(svg, "<polyline"), 4U);
    EXPECT_EQ(count(svg, "class=\"trajectory\""), 2U);
    EXPECT_EQ(svg.compare(svg.size() - 6, 6, "</svg>"), 0);
  }
}

TEST(SvgScene, EveryKindOfFailureHasItsOwnMarkAtTheEnd) {
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  const auto mark_of = [&](Outcome outcome) {
    SceneOptions options;
    options.max_pixels = 400;  // 50 pixels per meter
    options.trajectories = {{"run", {{1, 1}, {4, 2}}, outcome, ""}};
    const std::string svg = render_svg(scenario, options), end = "<path d=\"M200.0 100.0";
    const std::size_t at = svg.find(end);
    return at == std::string::npos ? "" : svg.substr(at, svg.find("stroke", at) - at);
  };
  std::set<std::string> marks;
  for (const Outcome outcome :
       {Outcome::Success, Outcome::Collision, Outcome::Timeout, Outcome::Stuck,
        Outcome::LeftWorkspace, Outcome::MethodCrash, Outcome::UnsolvableScenario})
    marks.insert(mark_of(outcome));
  EXPECT_EQ(marks.size(), 7U) << "a success has no mark, only a dot";
  for (const Outcome outcome :
       {Outcome::MethodDeadline, Outcome::MethodInvalidCommand, Outcome::MethodError})
    EXPECT_EQ(mark_of(outcome), mark_of(Outcome::MethodCrash));
}

TEST(SvgScene, MoversAreDrawnWithTheirPathsWhereTheyBegin) {
  const Scenario still = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  const Scenario moving = still.with_movers(
      {{"<a>", 0.3, {{-1, {3, 1}}, {1, {5, 1}}}}, {"b", 0.5, {{2, {6, 2}}, {4, {6, 1}}}}});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  const std::string svg = render_svg(moving, options);
  EXPECT_EQ(count(svg, "<polyline class=\"mover\""), 2U);
  EXPECT_EQ(count(svg, "cx=\"200.0\" cy=\"150.0\" r=\"15.0\""), 1U);  // at (4, 1) at 0 s
  EXPECT_EQ(count(svg, "cx=\"300.0\" cy=\"100.0\" r=\"25.0\""), 1U);  // appears at 2 s
  EXPECT_EQ(count(svg, "moving obstacle &lt;a&gt; at 0 s"), 1U);
  EXPECT_EQ(count(svg, "moving obstacle b at 2 s"), 1U);
  EXPECT_EQ(count(render_svg(still, options), "mover"), 0U);
}

TEST(SvgScene, PeopleAreDrawnAtTheirStartWithTheirRoutes) {
  const Scenario empty = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  const Scenario scenario = empty.with_people(
      {{"<p>", 0.3, 1, {3, 1}, {{5, 2}, {6, 1}}}, {"q", 0.5, 1, {2, 2}, {{2, 3}}, 4}});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  const std::string svg = render_svg(scenario, options);
  EXPECT_EQ(count(svg, "<polyline class=\"person\" points=\"150.0,150.0 250.0,100.0 300.0,150.0\""),
            1U)
      << svg;
  EXPECT_EQ(count(svg, "<circle class=\"person\" cx=\"150.0\" cy=\"150.0\" r=\"15.0\""), 1U);
  EXPECT_EQ(count(svg, "<circle class=\"person\" cx=\"100.0\" cy=\"100.0\" r=\"25.0\""), 1U);
  EXPECT_EQ(count(svg, "person &lt;p&gt; at 0 s"), 1U);
  EXPECT_EQ(count(svg, "person q at 4 s"), 1U);
  options.time = 1;  // of a run, in which they are nobody knows where
  EXPECT_EQ(count(render_svg(scenario, options), "<circle class=\"person\""), 0U);
  EXPECT_EQ(count(render_svg(empty, options), "person"), 0U);
}

TEST(SvgScene, PeopleAreDrawnWhereTheRecordOfARunSays) {
  const Movers scripted = {{"m", 0.3, {{0, {1, 1}}}}};
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3})
                                .with_movers(scripted)
                                .with_people({{"p", 0.5, 1, {3, 1}, {{6, 1}}}});
  const Movers record = {scripted[0], {"p", 0.5, {{0, {3, 1}}, {2, {5, 2}}}}};
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  options.movers = &record;
  options.time = 1;
  const std::string svg = render_svg(scenario, options);
  EXPECT_EQ(count(svg, "<circle class=\"mover\" cx=\"50.0\" cy=\"150.0\" r=\"15.0\""), 1U) << svg;
  EXPECT_EQ(count(svg, "<circle class=\"person\" cx=\"200.0\" cy=\"125.0\" r=\"25.0\""), 1U);
  EXPECT_EQ(count(svg, "<polyline class=\"person\" points=\"150.0,150.0 250.0,100.0\""), 1U);
}

TEST(SvgScene, NamesAreEscaped) {
  const Scenario scenario = sample_scenario(1, "</title><script>alert(1)</script>");
  EXPECT_EQ(count(render_svg(scenario, {}), "<script>"), 0U);
}

TEST(SvgScene, PicturesOfLargeMapsAreSmall) {
  mrpt::maps::COccupancyGridMap2D map(0, 60, 0, 60, 0.05F);
  RandomEngine engine(4);
  for (int y = 0; y < 1200; ++y)
    for (int x = 0; x < 1200; ++x) map.setCell(x, y, uniform_real(engine, 0, 1) < 0.02 ? 0.F : 1.F);
  const Scenario scenario = Scenario::grid("map", map, {1, 1, 0}, {50, 50});
  EXPECT_LT(render_svg(scenario, {}).size(), 600'000U);
}

TEST(SvgScene, AViewShowsItsPartOfTheWorkspace) {
  Primitives obstacles;
  obstacles.discs.push_back({{20, 10}, 0.5});
  const Scenario scenario =
      Scenario::continuous("s", {0, 0, 100, 100}, obstacles, {18, 9, 0}, {24, 9});
  SceneOptions options;
  options.max_pixels = 400;
  options.trajectories = {{"run", {{18, 9}, {19, 12}, {24, 9}}, Outcome::Success, ""}};
  const Bounds view = view_around(scenario, options.trajectories, 2);
  EXPECT_EQ(view, (Bounds{16, 7, 26, 14}));
  options.view = view;
  const std::string svg = render_svg(scenario, options);
  // 40 pixels per meter: 400 x 280; the disc is 4 m right of and 4 m below the upper left corner.
  EXPECT_NE(svg.find("viewBox=\"0 0 400 280\""), std::string::npos);
  EXPECT_NE(svg.find("<circle cx=\"160.0\" cy=\"160.0\" r=\"20.0\"/>"), std::string::npos);
  EXPECT_NE(svg.find("class=\"border\" x=\"-640\" y=\"-3440\" width=\"4000\" height=\"4000\""),
            std::string::npos);
  EXPECT_EQ(view_around(scenario, {{"", {{-5, 200}}, Outcome::LeftWorkspace, ""}}, 2),
            (Bounds{0, 7, 26, 100}))
      << "not beyond the workspace";
}

TEST(SvgScene, AViewOfAMapHasTheCellsThatItShows) {
  // A column of occupied cells at x = 1 m and one at 3 m, of 0.125 m.
  mrpt::maps::COccupancyGridMap2D map(0, 4, 0, 2, 0.125F);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) map.setCell(x, y, x == 8 || x == 24 ? 0.F : 1.F);
  const Scenario scenario = Scenario::grid("map", map, {2, 1, 0}, {2.5, 1});
  SceneOptions options;
  options.max_pixels = 400;
  EXPECT_NE(render_svg(scenario, options).find("d=\"M8 0h1v16h-1zM24 0h1v16h-1z\""),
            std::string::npos);
  // The upper right quarter: 2 m are 400 pixels, a cell has 25. The corner of the cells is 2 m left
  // of the picture and 1 m below it.
  options.view = Bounds{2, 1, 4, 2};
  EXPECT_NE(render_svg(scenario, options).find("matrix(25 0 0 -25 -400 400)\" d=\"M24 8h1v8h-1z\""),
            std::string::npos)
      << render_svg(scenario, options);
}

}  // namespace
}  // namespace slalom
