// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/scenario/convert.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/scenario/scenario.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

const Bounds kBounds{0, 0, 4, 3};
const Primitives kObstacles{{{{2, 1}, 0.5}}, {{{{1, 2}, {2, 2}, {2, 2.5}}}}};

Scenario sample(const std::string& name = "sample") {
  return Scenario::continuous(name, kBounds, kObstacles, {0.5, 0.5, 0}, {3.5, 2.5});
}

COccupancyGridMap2D small_map() {
  COccupancyGridMap2D map;
  map.setSize(-1, 0, 2, 2.5F, 0.1F, 1.0F);
  return map;
}

TEST(Scenario, HasANameInUtf8) {
  EXPECT_EQ(sample("caf\xc3\xa9").name(), "caf\xc3\xa9");
  for (const auto& make : {std::function<void()>([] { sample("caf\xe9"); }),
                           std::function<void()>([] { sample().renamed("caf\xe9"); })})
    EXPECT_TRUE(throws_error(ErrorKind::File,
                             "name of a scenario 'caf\\xe9': ", {"byte 4 is not UTF-8"}, make));
}

TEST(Scenario, IsIdentifiedByItsContentNotItsName) {
  EXPECT_EQ(sample().hash(), sample("other").hash());
  EXPECT_EQ(sample().hash().size(), 32U);
  EXPECT_EQ(sample().renamed("new").hash(), sample().hash());
  EXPECT_EQ(sample().renamed("new").name(), "new");
  EXPECT_NE(sample().with_start_goal({0.6, 0.5, 0}, {3.5, 2.5}).hash(), sample().hash());
  EXPECT_NE(sample().with_start_goal({0.5, 0.5, 0.1}, {3.5, 2.5}).hash(), sample().hash());
  EXPECT_NE(sample().with_start_goal({0.5, 0.5, 0}, {3.5, 2.4}).hash(), sample().hash());
  EXPECT_EQ(sample().with_start_goal({0.5, 0.5, 0}, {3.5, 2.5}).hash(), sample().hash());
}

TEST(Scenario, TheHeadingOfAGoalIsPartOfItsContent) {
  EXPECT_EQ(sample().goal_heading(), std::nullopt);
  const Scenario with = sample().with_goal_heading(1.5);
  EXPECT_EQ(with.goal_heading(), 1.5);
  EXPECT_NE(with.hash(), sample().hash());
  EXPECT_NE(with.hash(), sample().with_goal_heading(0).hash());
  EXPECT_EQ(with.with_goal_heading(std::nullopt).hash(), sample().hash());
  EXPECT_EQ(sample().with_goal_heading(1.5).hash(), with.hash());
  const Mover mover{"a", 0.1, {{0, {1, 1}}, {1, {2, 1}}}, MoverEnd::Stop};
  EXPECT_EQ(with.with_movers({mover}).goal_heading(), 1.5);
  EXPECT_EQ(with.with_start_goal({1, 1, 0}, {3, 2.5}).goal_heading(), 1.5);
  const Scenario both = with.with_movers({mover});
  EXPECT_EQ(sample().with_rest_of(both).hash(), both.hash());
  ConversionOptions options;
  options.resolution = 0.1;
  for (const Representation to : {Representation::Grid, Representation::Points})
    EXPECT_EQ(convert(with, to, options).goal_heading(), 1.5);
  EXPECT_TRUE(throws_error(ErrorKind::File, "sample: goal heading", {"finite angle"},
                           [] { sample().with_goal_heading(std::nan("")); }));
}

PublishedPathPtr published(std::vector<TPoint2D> points, double cell_size = 0.5) {
  return std::make_shared<PublishedPath>(PublishedPath{std::move(points), {0, 0, 3, 2}, cell_size});
}

TEST(Scenario, HasAPublishedPathOutsideItsContent) {
  const Scenario with = sample().with_published_path(published({{1, 1}, {1, 1}, {2, 1}}));
  EXPECT_EQ(with.hash(), sample().hash());
  EXPECT_EQ(sample().published_path(), nullptr);
  ASSERT_NE(with.published_path(), nullptr);
  EXPECT_EQ(with.published_path()->points.size(), 3U);
  EXPECT_EQ(with.published_path()->size_x(), 6);  // 3 m of 0.5 m
  EXPECT_EQ(with.published_path()->size_y(), 4);
  EXPECT_EQ(with.renamed("other").published_path(), with.published_path());
  EXPECT_EQ(convert(with, Representation::Grid, 0.1).published_path(), with.published_path());
  EXPECT_EQ(convert(with, Representation::Points, 0.1).published_path(), with.published_path());
  EXPECT_EQ(with.with_start_goal({0.6, 0.5, 0}, {3.5, 2.5}).published_path(), nullptr);
  EXPECT_EQ(with.with_published_path(nullptr).published_path(), nullptr);
}

TEST(Scenario, RefusesInvalidPublishedPaths) {
  const double nan = std::nan("");
  for (const PublishedPathPtr& bad :
       {published({}), published({{nan, 0}}), published({{1, 1}}, 0), published({{1, 1}}, -0.5),
        published({{1, 1}}, 0.7), published({{1, 1}}, 1e-6), published({{1, 1}}, nan)})
    EXPECT_THROW(sample().with_published_path(bad), Error);
}

TEST(Scenario, HashesDistinguishPublishedPaths) {
  const auto path = published({{1, 1}, {2, 1}});
  EXPECT_EQ(path->hash(), published({{1, 1}, {2, 1}})->hash());
  EXPECT_NE(path->hash(), published({{1, 1}, {2, 1.5}})->hash());
  EXPECT_NE(path->hash(), published({{1, 1}, {2, 1}}, 0.25)->hash());
}

TEST(Scenario, ChangesItsHashWithEveryNumberOfItsGeometry) {
  Primitives obstacles = kObstacles;
  obstacles.discs[0].radius = 0.5000001;
  EXPECT_NE(Scenario::continuous("", kBounds, obstacles, {0.5, 0.5, 0}, {3.5, 2.5}).hash(),
            sample().hash());
  obstacles = kObstacles;
  obstacles.polygons[0].vertices[1].x = 2.1;
  EXPECT_NE(Scenario::continuous("", kBounds, obstacles, {0.5, 0.5, 0}, {3.5, 2.5}).hash(),
            sample().hash());
  EXPECT_NE(Scenario::continuous("", {0, 0, 4, 3.5}, kObstacles, {0.5, 0.5, 0}, {3.5, 2.5}).hash(),
            sample().hash());
}

TEST(Scenario, BinarizesGridsWithUnknownCellsOccupied) {
  COccupancyGridMap2D map = small_map();
  map.setCell(1, 0, 0.1F);
  map.setCell(2, 0, 0.49F);
  map.setCell(3, 0, 0.5F);
  map.setCell(4, 0, 0.52F);
  map.setCell(5, 0, 0.9F);
  const Scenario scenario = Scenario::grid("grid", map, {-0.5, 2.2, 0}, {-0.1, 2.4});
  const Occupancy cells = make_occupancy(scenario, 1);
  const bool expected[] = {false, true, true, true, false, false};
  for (int cx = 0; cx < 6; ++cx) EXPECT_EQ(cells.occupied(cx, 0), expected[cx]) << cx;
  EXPECT_EQ(cells.count_occupied(), 3U);
  EXPECT_EQ(scenario.grid_map()->getRow(0)[1], COccupancyGridMap2D::p2l(0.0F));
  EXPECT_EQ(scenario.grid_map()->getRow(0)[4], COccupancyGridMap2D::p2l(1.0F));
}

TEST(Scenario, HashesAGridAfterBinarization) {
  COccupancyGridMap2D faint = small_map(), sure = small_map(), other = small_map();
  faint.setCell(3, 2, 0.4F);
  sure.setCell(3, 2, 0.0F);
  other.setCell(2, 3, 0.0F);
  const TPose2D start{-0.5, 2.2, 0};
  const TPoint2D goal(-0.1, 2.4);
  EXPECT_EQ(Scenario::grid("a", faint, start, goal).hash(),
            Scenario::grid("b", sure, start, goal).hash());
  EXPECT_NE(Scenario::grid("a", other, start, goal).hash(),
            Scenario::grid("b", sure, start, goal).hash());
}

TEST(Scenario, TakesTheBoundsOfAGridFromItsCells) {
  const Scenario scenario = Scenario::grid("grid", small_map(), {-0.5, 2.2, 0}, {-0.1, 2.4});
  EXPECT_EQ(scenario.bounds(), make_occupancy(scenario, 1).bounds());
  EXPECT_EQ(scenario.bounds().x_min, -1);
  EXPECT_NEAR(scenario.bounds().y_max, 2.5, 1e-6);
}

TEST(Scenario, KeepsThePointsOfAPointMap) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPoint(1, 2);
  const Scenario scenario = Scenario::points("points", kBounds, points, {0.5, 0.5, 0}, {3, 2});
  points.insertPoint(2, 2);  // the scenario has its own copy
  EXPECT_EQ(scenario.point_map()->size(), 1U);
  EXPECT_EQ(scenario.representation(), Representation::Points);
  EXPECT_NE(Scenario::points("points", kBounds, points, {0.5, 0.5, 0}, {3, 2}).hash(),
            scenario.hash());
}

TEST(Scenario, RefusesInvalidBoundsStartsAndGoals) {
  const auto make = [](Bounds bounds, TPose2D start, TPoint2D goal) {
    return Scenario::continuous("bad", bounds, {}, start, goal);
  };
  EXPECT_NO_THROW(make(kBounds, {1, 1, 0}, {2, 2}));
  EXPECT_THROW(make({0, 0, 0, 3}, {0, 1, 0}, {0, 2}), Error);
  EXPECT_THROW(make({0, 0, 4, HUGE_VAL}, {1, 1, 0}, {2, 2}), Error);
  EXPECT_THROW(make({0, 0, std::nan(""), 3}, {1, 1, 0}, {2, 2}), Error);
  EXPECT_THROW(make(kBounds, {5, 1, 0}, {2, 2}), Error);
  EXPECT_THROW(make(kBounds, {1, 1, 0}, {2, -0.1}), Error);
  EXPECT_THROW(make(kBounds, {1, std::nan(""), 0}, {2, 2}), Error);
  EXPECT_THROW(make(kBounds, {1, 1, std::nan("")}, {2, 2}), Error);
}

TEST(Scenario, RefusesDegeneratePrimitivesByNumber) {
  const auto make = [](const Primitives& obstacles) {
    Scenario::continuous("bad", kBounds, obstacles, {1, 1, 0}, {2, 2});
  };
  const auto refused = [&](const Primitives& obstacles, const std::string& which) {
    return throws_error(ErrorKind::File, "bad: ", {which}, [&] { make(obstacles); });
  };
  EXPECT_TRUE(refused({{{{1, 1}, 1}, {{1, 1}, 0}}, {}}, "disc 1"));
  EXPECT_TRUE(refused({{{{std::nan(""), 1}, 1}}, {}}, "disc 0"));
  EXPECT_TRUE(refused({{}, {{{{0, 0}, {2, 2}, {2, 0}, {0, 3}}}}}, "polygon 0"));
  EXPECT_NO_THROW(make(kObstacles));
}

TEST(Scenario, RepresentationsHaveTheNamesStoredInLists) {
  EXPECT_EQ(to_string(Representation::Continuous), "continuous");
  EXPECT_EQ(to_string(Representation::Grid), "grid");
  EXPECT_EQ(to_string(Representation::Points), "points");
}

}  // namespace
}  // namespace slalom
