// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/commands/edit_geometry.h>
#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace slalom {
namespace {

/// 10 x 6 m with a disc in the middle and a square that overlaps it on the right.
Scenario primitives_scenario() {
  Primitives obstacles;
  obstacles.discs.push_back({{5, 3}, 1});
  obstacles.polygons.push_back({{{5.5, 2}, {7.5, 2}, {7.5, 4}, {5.5, 4}}});
  return Scenario::continuous("edited", {0, 0, 10, 6}, obstacles, {1, 1, 0}, {9, 5});
}

/// 20 x 10 free cells of 0.5 m.
Scenario empty_grid() {
  return Scenario::grid("cells", make_grid_map(20, 10, 0.5, {0, 0}), {0.75, 0.75, 0}, {9.25, 4.25});
}

Scenario three_points() {
  mrpt::maps::CSimplePointsMap map;
  for (const float x : {2.0F, 4.0F, 6.0F}) map.insertPoint(x, 3, 0);
  return Scenario::points("scan", {0, 0, 10, 6}, map, {1, 1, 0}, {9, 5});
}

int occupied_cells(const Scenario& scenario) {
  int count = 0;
  for (unsigned cy = 0; cy < scenario.grid_map()->getSizeY(); ++cy)
    for (unsigned cx = 0; cx < scenario.grid_map()->getSizeX(); ++cx)
      count += scenario.grid_map()->getCell(static_cast<int>(cx), static_cast<int>(cy)) < 0.5F;
  return count;
}

void expect_refused(const std::function<void()>& edit, const std::string& what,
                    const std::string& expected) {
  const std::string text = error_text(ErrorKind::Usage, edit);
  EXPECT_NE(text[0], '(') << text;
  EXPECT_TRUE(mentions(text, {what, expected}));
}

TEST(EditGeometry, MovesStartAndGoalAndKeepsTheName) {
  const Scenario before = primitives_scenario();
  const Scenario moved = with_goal(with_start(before, {2, 2, 0.5}), {9, 1});
  EXPECT_EQ(moved.name(), "edited");
  EXPECT_NE(moved.hash(), before.hash());
  EXPECT_DOUBLE_EQ(moved.start().phi, 0.5);
  EXPECT_DOUBLE_EQ(moved.goal().y, 1);
  EXPECT_EQ(with_goal(with_start(moved, before.start()), before.goal()).hash(), before.hash());
}

TEST(EditGeometry, RefusesStartAndGoalOutsideOrOnObstacles) {
  const Scenario scenario = primitives_scenario();
  expect_refused(
      [&] {
        with_start(scenario, {-1, 1, 0});
      },
      "start at (-1, 1) is outside", "within (0, 0) to (10, 6)");
  expect_refused(
      [&] {
        with_start(scenario, {5, 3, 0});
      },
      "start at (5, 3) is on an obstacle", "a free point");
  expect_refused([&] { with_goal(scenario, {7, 3}); }, "goal at (7, 3) is on an obstacle", "free");
  expect_refused([&] { with_start(scenario, {1, 1, NAN}); }, "heading", "an angle");
  const Scenario cells = with_cells_painted(empty_grid(), {{{5.25, 2.25}}, 0}, true);
  expect_refused([&] { with_goal(cells, {5.3, 2.4}); }, "on an obstacle", "free");
  EXPECT_NO_THROW(with_goal(cells, {5.6, 2.4}));
}

TEST(EditGeometry, FindsTheTopmostObstacleOrTheNearestWithinTheTolerance) {
  const Scenario scenario = primitives_scenario();
  EXPECT_EQ(obstacle_at(scenario, {4.5, 3}, 0), 0U);
  EXPECT_EQ(obstacle_at(scenario, {5.7, 3}, 0), 1U) << "in both: the polygon is on top";
  EXPECT_EQ(obstacle_at(scenario, {3.9, 3}, 0.05), std::nullopt);
  EXPECT_EQ(obstacle_at(scenario, {3.9, 3}, 0.2), 0U);
  // 1 m above the disc's top; 0.86 m left of and 1 m above the polygon's corner: 1.32 m away.
  EXPECT_EQ(obstacle_at(scenario, {4.64, 5}, 2), 0U);
  EXPECT_EQ(obstacle_at(empty_grid(), {1, 1}, 5), std::nullopt);
}

TEST(EditGeometry, AddsMovesAndRemovesObstacles) {
  const Scenario scenario = primitives_scenario();
  const Scenario more = with_obstacle_added(with_obstacle_added(scenario, Disc{{2, 5}, 0.5}),
                                            Polygon{{{8, 1}, {9, 1}, {9, 2}}});
  EXPECT_EQ(obstacle_count(more.primitives()), 4U);
  EXPECT_EQ(obstacle_at(more, {2, 5}, 0), 1U) << "polygons come after discs";
  const Scenario moved = with_obstacle_moved(with_obstacle_moved(more, 1, 1, -0.5), 3, 0, 2);
  EXPECT_DOUBLE_EQ(moved.primitives().discs[1].center.x, 3);
  EXPECT_DOUBLE_EQ(moved.primitives().discs[1].center.y, 4.5);
  EXPECT_DOUBLE_EQ(moved.primitives().polygons[1].vertices[0].y, 3);
  const Scenario fewer = with_obstacle_removed(with_obstacle_removed(more, 3), 1);
  EXPECT_EQ(fewer.hash(), scenario.hash());
}

TEST(EditGeometry, RefusesInvalidObstacles) {
  const Scenario scenario = primitives_scenario();
  expect_refused(
      [&] {
        with_obstacle_added(scenario, Disc{{1.2, 1}, 0.5});
      },
      "would cover the start at (1, 1)", "leave start and goal free");
  expect_refused([&] { with_obstacle_moved(scenario, 1, 2.5, 1.5); }, "would cover the goal",
                 "leave start and goal free");
  expect_refused(
      [&] {
        with_obstacle_added(scenario, Disc{{2, 4}, 0});
      },
      "radius 0", "positive radius");
  expect_refused([&] { with_obstacle_added(scenario, Polygon{}); }, "0 vertices", "at least 3");
  expect_refused(
      [&] {
        with_obstacle_added(scenario, Polygon{{{2, 4}, {3, 5}, {3, 4}, {2, 5}}});
      },
      "polygon of 4 vertices", "no crossing edges");
  expect_refused([&] { with_obstacle_moved(scenario, 0, 100, 0); }, "outside the workspace",
                 "touches the workspace");
  expect_refused([&] { with_obstacle_moved(scenario, 1, 0, -100); }, "outside the workspace",
                 "touches the workspace");
  expect_refused([&] { with_obstacle_moved(scenario, 0, NAN, 0); }, "degenerate", "finite");
  expect_refused([&] { with_obstacle_removed(scenario, 2); }, "obstacle 2", "0 to 1");
  expect_refused([&] { with_obstacle_removed(empty_grid(), 0); }, "for grid scenarios",
                 "continuous");
}

TEST(EditGeometry, AcceptsAPolygonThatCrossesTheWorkspaceWithoutAVertexInside) {
  Scenario scenario = Scenario::continuous("p", {0, 0, 10, 6}, {}, {1, 1, 0}, {9, 5});
  // Its corners lie outside; its edges cross the workspace between x = 4 and x = 6.
  EXPECT_NO_THROW(with_obstacle_added(scenario, Polygon{{{4, -2}, {6, -2}, {6, 8}, {4, 8}}}));
  expect_refused(
      [&] {
        with_obstacle_added(scenario, Polygon{{{11, -2}, {13, -2}, {13, 8}}});
      },
      "outside the workspace", "touches the workspace");
}

TEST(EditGeometry, PaintsTheCellsUnderTheBrush) {
  const Scenario before = empty_grid();
  // Cells are 0.5 m: a point paints its own cell only.
  EXPECT_EQ(occupied_cells(with_cells_painted(before, {{{5.1, 2.1}}, 0}, true)), 1);
  // Centers at y = 2.25 from x = 3.25 to 6.25 lie on the stroke: 7 cells; those 0.5 m above and
  // below are not under a brush of 0.4 m.
  const Stroke line{{{3.25, 2.25}, {6.25, 2.25}}, 0.4};
  const Scenario wall = with_cells_painted(before, line, true);
  EXPECT_EQ(occupied_cells(wall), 7);
  EXPECT_EQ(wall.name(), "cells");
  EXPECT_NE(wall.hash(), before.hash());
  EXPECT_EQ(with_cells_painted(wall, line, false).hash(), before.hash());
  // With 0.5 m the rows above and below and one cell beyond each end come in: 3 * 7 + 2.
  EXPECT_EQ(occupied_cells(with_cells_painted(before, {line.points, 0.5}, true)), 23);
}

TEST(EditGeometry, PaintsNothingOutsideTheGridAndNeverStartOrGoal) {
  const Scenario before = empty_grid();
  EXPECT_EQ(with_cells_painted(before, {{{-50, 2}, {-40, 2}}, 0.2}, true).hash(), before.hash());
  expect_refused(
      [&] {
        with_cells_painted(before, {{{0.75, 0.75}}, 0.1}, true);
      },
      "would cover the start", "leave start and goal free");
  expect_refused(
      [&] {
        with_cells_painted(before, {{{9, 4}}, 1}, true);
      },
      "cover the goal", "leave start and goal free");
  expect_refused([&] { with_cells_painted(before, {{}, 1}, true); }, "stroke", "finite points");
  expect_refused(
      [&] {
        with_cells_painted(before, {{{1, 1}}, -1}, true);
      },
      "brush radius", "0 or more");
  expect_refused(
      [&] {
        with_cells_painted(three_points(), {{{1, 1}}, 1}, true);
      },
      "for points scenarios", "a grid scenario");
}

TEST(EditGeometry, AddsAndRemovesPointsOfAPointMap) {
  const Scenario before = three_points();
  const Scenario more = with_points_added(before, {{8, 3}, {8, 4}});
  EXPECT_EQ(more.point_map()->size(), 5U);
  EXPECT_EQ(with_points_removed(more, {{{8, 2.5}, {8, 5}}, 0.1}).hash(), before.hash());
  EXPECT_EQ(with_points_removed(before, {{{3, 3}}, 1}).point_map()->size(), 1U)
      << "points at a distance of 1 m are removed";
  expect_refused(
      [&] {
        with_points_added(before, {{3, 3}, {11, 3}});
      },
      "a point at (11, 3)", "within");
  expect_refused(
      [&] {
        with_points_removed(empty_grid(), {{{3, 3}}, 1});
      },
      "for grid scenarios", "points");
}

TEST(EditGeometry, KeepsMovers) {
  const Movers movers{{"a", 0.3, {{0, {4, 5}}, {5, {6, 5}}}, MoverEnd::Stop}};
  const Scenario discs = primitives_scenario().with_movers(movers);
  const Scenario cells = empty_grid().with_movers(movers);
  const Scenario points = three_points().with_movers(movers);
  for (const Scenario& edited :
       {with_start(discs, {2, 2, 0}), with_goal(discs, {9, 1}),
        with_obstacle_moved(discs, 0, 0.1, 0), with_obstacle_added(discs, Disc{{2, 5}, 0.5}),
        with_obstacle_removed(discs, 0), with_cells_painted(cells, {{{5.1, 2.1}}, 0}, true),
        with_points_added(points, {{8, 3}}), with_points_removed(points, {{{2, 3}}, 0.1})})
    EXPECT_EQ(edited.movers(), movers);
}

TEST(EditGeometry, DropsAPublishedPath) {
  auto path = std::make_shared<PublishedPath>();
  path->points = {{1, 1}, {9, 5}};
  path->field = {0, 0, 10, 6};
  path->cell_size = 0.5;
  const Scenario scenario = primitives_scenario().with_published_path(path);
  EXPECT_EQ(with_obstacle_moved(scenario, 0, 0.1, 0).published_path(), nullptr);
  EXPECT_EQ(with_start(scenario, {2, 1, 0}).published_path(), nullptr);
}

}  // namespace
}  // namespace slalom
