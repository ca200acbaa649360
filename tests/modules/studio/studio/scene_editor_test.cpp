// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/error.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/studio/scene_editor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

constexpr double kTolerance = 0.1;

/// A disc at (5, 3) and a square with a corner at (7, 1) in a room of 10 m by 6 m.
Scenario room() {
  Primitives obstacles;
  obstacles.discs.push_back({{5, 3}, 0.5});
  obstacles.polygons.push_back({{{7, 1}, {8, 1}, {8, 2}, {7, 2}}});
  return Scenario::continuous("room", {0, 0, 10, 6}, obstacles, {1, 3, 0.5}, {9, 3});
}

std::optional<SceneEdit> drag(SceneEditor& editor, const Scenario& scenario,
                              const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to) {
  editor.press(scenario, from, kTolerance);
  editor.move({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)});
  editor.move(to);
  return editor.release(scenario, to);
}

TEST(SceneEditor, DoesNotEditUntilAToolIsChosen) {
  SceneEditor editor;
  EXPECT_FALSE(drag(editor, room(), {2, 2}, {3, 3}).has_value());
  EXPECT_FALSE(editor.busy());
}

TEST(SceneEditor, MovesTheStartAndRotatesItByDragging) {
  SceneEditor editor;
  editor.set_tool(EditTool::Start);
  const auto turned = drag(editor, room(), {2, 4}, {2, 5});
  ASSERT_TRUE(turned.has_value());
  EXPECT_EQ(turned->title, "Move start");
  EXPECT_DOUBLE_EQ(turned->scenario.start().x, 2);
  EXPECT_DOUBLE_EQ(turned->scenario.start().y, 4);
  EXPECT_NEAR(turned->scenario.start().phi, std::atan2(1, 0), 1e-12);
  const auto clicked = drag(editor, room(), {2, 4}, {2.05, 4});  // no drag: less than tolerance
  EXPECT_DOUBLE_EQ(clicked->scenario.start().phi, 0.5);
  EXPECT_NE(clicked->scenario.hash(), room().hash());
}

TEST(SceneEditor, SetsTheGoalAndAHeadingByADrag) {
  SceneEditor editor;
  editor.set_tool(EditTool::Goal);
  const auto clicked = drag(editor, room(), {8, 5}, {8, 5.05});  // no drag: less than tolerance
  EXPECT_EQ(clicked->scenario.goal(), mrpt::math::TPoint2D(8, 5));
  EXPECT_FALSE(clicked->scenario.goal_heading());
  const auto turned = drag(editor, room(), {8, 5}, {8, 4});
  EXPECT_EQ(turned->scenario.goal(), mrpt::math::TPoint2D(8, 5));
  ASSERT_TRUE(turned->scenario.goal_heading());
  EXPECT_NEAR(*turned->scenario.goal_heading(), -M_PI / 2, 1e-12);
  const auto moved = drag(editor, turned->scenario, {8, 3}, {8, 3});
  EXPECT_EQ(moved->scenario.goal_heading(), turned->scenario.goal_heading()) << "a click keeps it";
  const auto removed = drag(editor, turned->scenario, {8.05, 5}, {8.05, 5});
  EXPECT_EQ(removed->scenario.hash(), clicked->scenario.hash());
}

TEST(SceneEditor, AddsADiscOfTheDraggedOrTheBrushRadius) {
  SceneEditor editor;
  editor.set_tool(EditTool::Disc);
  const auto dragged = drag(editor, room(), {3, 1}, {3, 1.7});
  ASSERT_EQ(dragged->scenario.primitives().discs.size(), 2U);
  EXPECT_NEAR(dragged->scenario.primitives().discs[1].radius, 0.7, 1e-12);
  editor.set_brush(0.4);
  const auto clicked = drag(editor, room(), {3, 1}, {3, 1});
  EXPECT_DOUBLE_EQ(clicked->scenario.primitives().discs[1].radius, 0.4);
}

TEST(SceneEditor, ClosesAPolygonAtItsFirstCorner) {
  SceneEditor editor;
  const Scenario scenario = room();
  editor.set_tool(EditTool::Polygon);
  for (const auto& corner : {mrpt::math::TPoint2D(2, 1), {3, 1}, {3, 2}})
    EXPECT_FALSE(drag(editor, scenario, corner, corner).has_value());
  EXPECT_TRUE(editor.busy());
  editor.move({2, 2});
  EXPECT_EQ(editor.preview(scenario).open_polygon.size(), 4U);
  const auto edit = drag(editor, scenario, {2.05, 1}, {2.05, 1});
  ASSERT_TRUE(edit.has_value());
  ASSERT_EQ(edit->scenario.primitives().polygons.size(), 2U);
  EXPECT_EQ(edit->scenario.primitives().polygons[1].vertices.size(), 3U);
  EXPECT_FALSE(editor.busy());
}

TEST(SceneEditor, FinishesAPolygonOnlyWithThreeCorners) {
  SceneEditor editor;
  const Scenario scenario = room();
  editor.set_tool(EditTool::Polygon);
  for (const auto& corner : {mrpt::math::TPoint2D(2, 1), {3, 1}})
    drag(editor, scenario, corner, corner);
  EXPECT_FALSE(editor.finish(scenario).has_value());
  drag(editor, scenario, {3, 2}, {3, 2});
  EXPECT_TRUE(editor.finish(scenario).has_value());
}

TEST(SceneEditor, MovesAndDeletesThePressedObstacle) {
  SceneEditor editor;
  editor.set_tool(EditTool::Move);
  const auto moved = drag(editor, room(), {7.5, 1.5}, {7.5, 3.5});
  ASSERT_TRUE(moved.has_value());
  EXPECT_NEAR(moved->scenario.primitives().polygons[0].vertices[0].y, 3, 1e-12);
  EXPECT_FALSE(drag(editor, room(), {2, 5}, {3, 5}).has_value());  // nothing is there
  editor.set_tool(EditTool::Delete);
  const auto deleted = drag(editor, room(), {5, 3}, {5, 3});
  ASSERT_TRUE(deleted.has_value());
  EXPECT_TRUE(deleted->scenario.primitives().discs.empty());
  EXPECT_EQ(deleted->scenario.primitives().polygons.size(), 1U);
}

TEST(SceneEditor, PaintsAndErasesCellsAlongTheStroke) {
  const auto map = make_grid_map(100, 60, 0.1, {0, 0});
  const Scenario grid = Scenario::grid("grid", map, {1, 3, 0}, {9, 3});
  SceneEditor editor;
  editor.set_tool(EditTool::Paint);
  editor.set_brush(0.2);
  const auto painted = drag(editor, grid, {4, 1}, {4, 2});
  ASSERT_TRUE(painted.has_value());
  const Occupancy cells = make_occupancy(painted->scenario, 0.1);
  EXPECT_TRUE(cells.occupied(40, 15));
  EXPECT_FALSE(cells.occupied(45, 15));
  editor.set_tool(EditTool::Erase);
  const auto erased = drag(editor, painted->scenario, {4, 1}, {4, 2});
  EXPECT_EQ(erased->scenario.hash(), grid.hash());
}

TEST(SceneEditor, CancelsInvalidEdits) {
  SceneEditor editor;
  editor.set_tool(EditTool::Goal);
  EXPECT_THROW(drag(editor, room(), {5, 3}, {8, 3}), Error);  // in the disc
  EXPECT_FALSE(editor.busy());
  editor.press(room(), {2, 2}, kTolerance);
  ASSERT_TRUE(editor.preview(room()).goal.has_value());
  EXPECT_EQ(editor.preview(room()).goal->position, mrpt::math::TPoint2D(2, 2));
  editor.cancel();
  EXPECT_FALSE(editor.preview(room()).goal.has_value());
}

TEST(EditTools, HaveUniqueIdsAndKeysAndDependOnRepresentations) {
  std::set<std::string> ids;
  std::set<char> keys;
  for (const EditToolInfo& info : edit_tools()) {
    EXPECT_TRUE(ids.insert(info.id).second);
    EXPECT_TRUE(keys.insert(info.key).second);
    EXPECT_EQ(&info_of(info.tool), &info);
  }
  for (const char key : {'F', 'L', 'Q', 'W'}) EXPECT_EQ(keys.count(key), 0U);  // used by the view
  const Scenario grid =
      Scenario::grid("grid", make_grid_map(10, 10, 0.5, {0, 0}), {1, 1, 0}, {4, 4});
  mrpt::maps::CSimplePointsMap point;
  point.insertPoint(3, 3, 0);
  const Scenario points = Scenario::points("points", {0, 0, 5, 5}, point, {1, 1, 0}, {4, 4});
  EXPECT_EQ(tool_disabled_reason(EditTool::Disc, room()), "");
  EXPECT_NE(tool_disabled_reason(EditTool::Disc, grid), "");
  EXPECT_NE(tool_disabled_reason(EditTool::Paint, room()), "");
  EXPECT_EQ(tool_disabled_reason(EditTool::Erase, points), "");
  EXPECT_EQ(tool_disabled_reason(EditTool::Goal, grid), "");
  EXPECT_EQ(tool_disabled_reason(EditTool::Mover, grid), "");
  const Scenario moving = grid.with_movers({{"a", 0.2, {{0, {2, 2}}}}});
  for (const EditTool tool : {EditTool::Move, EditTool::Delete}) {
    EXPECT_NE(tool_disabled_reason(tool, grid), "");
    EXPECT_EQ(tool_disabled_reason(tool, moving), "") << "cells cannot be moved, movers can";
  }
  EXPECT_NE(tool_disabled_reason(EditTool::Disc, moving), "");
  EXPECT_EQ(tool_disabled_reason(EditTool::Person, grid), "");
  const Scenario peopled = grid.with_people({{"a", 0.2, 1, {2, 2}, {{3, 2}}}});
  EXPECT_EQ(tool_disabled_reason(EditTool::Move, peopled), "");
}

TEST(SceneEditor, DrawsThePathOfAMoverWithTimes) {
  SceneEditor editor;
  const Scenario scenario = room();
  editor.set_tool(EditTool::Mover);
  editor.set_speed(0.5);
  editor.set_brush(0.3);
  EXPECT_FALSE(editor.can_finish());
  EXPECT_FALSE(drag(editor, scenario, {2, 1}, {2, 1}).has_value());
  EXPECT_TRUE(editor.can_finish()) << "a mover may stand";
  editor.move({4, 1});
  ASSERT_TRUE(editor.preview(scenario).mover.has_value());
  EXPECT_DOUBLE_EQ(editor.preview(scenario).mover->waypoints[1].t, 4) << "2 m at 0.5 m/s";
  EXPECT_FALSE(drag(editor, scenario, {4, 1}, {4, 1}).has_value());
  const auto edit = editor.finish(scenario);
  ASSERT_TRUE(edit.has_value());
  EXPECT_EQ(edit->title, "Add moving obstacle");
  const Mover expected{"mover_1", 0.3, {{0, {2, 1}}, {4, {4, 1}}}, MoverEnd::Stop};
  EXPECT_EQ(edit->scenario.movers(), Movers{expected});
  EXPECT_FALSE(editor.busy());
}

TEST(SceneEditor, ClosesThePathOfAMoverAtItsStart) {
  SceneEditor editor;
  editor.set_tool(EditTool::Mover);
  for (const auto& point : {mrpt::math::TPoint2D(2, 1), {4, 1}})
    EXPECT_FALSE(drag(editor, room(), point, point).has_value());
  const auto edit = drag(editor, room(), {2.05, 1}, {2.05, 1});
  ASSERT_TRUE(edit.has_value());
  const Mover expected{"mover_1", 0.25, {{0, {2, 1}}, {2, {4, 1}}, {4, {2, 1}}}, MoverEnd::Loop};
  EXPECT_EQ(edit->scenario.movers(), Movers{expected}) << "to and fro, again and again";
}

TEST(SceneEditor, MovesAndDeletesMoversWhereTheyAre) {
  const Mover walker{"a", 0.4, {{0, {2, 1}}, {4, {6, 1}}}, MoverEnd::Stop};
  const Scenario scenario = room().with_movers({walker});
  SceneEditor editor;
  editor.set_tool(EditTool::Move);
  const auto drag_at = [&](double time, const mrpt::math::TPoint2D& from,
                           const mrpt::math::TPoint2D& to) {
    editor.press(scenario, from, kTolerance, time);
    editor.move(to);
    return editor.release(scenario, to);
  };
  const auto all = drag_at(2, {4.1, 1}, {4.1, 2});  // its disc is at (4, 1)
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(all->title, "Move moving obstacle");
  EXPECT_EQ(all->scenario.movers()[0].waypoints[0].position.y, 2);
  EXPECT_EQ(all->scenario.movers()[0].waypoints[1].position.y, 2);
  const auto end = drag_at(2, {6.05, 1}, {6.05, 2});
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->title, "Move waypoint");
  EXPECT_EQ(end->scenario.movers()[0].waypoints[0].position.y, 1);
  EXPECT_EQ(end->scenario.movers()[0].waypoints[1].position.y, 2);
  EXPECT_EQ(drag_at(2, {5, 3}, {5, 4})->title, "Move obstacle") << "the disc beside them";
  EXPECT_FALSE(drag_at(0, {4.1, 1}, {4.1, 2}).has_value()) << "it is elsewhere at 0 s";
  editor.set_tool(EditTool::Delete);
  const auto deleted = drag_at(2, {4.1, 1}, {4.1, 1});
  EXPECT_EQ(deleted->scenario.hash(), room().hash());
  EXPECT_EQ(deleted->title, "Delete moving obstacle");
}

TEST(SceneEditor, DrawsTheRouteOfAPerson) {
  SceneEditor editor;
  const Scenario scenario = room();
  editor.set_tool(EditTool::Person);
  editor.set_speed(1.3);
  editor.set_brush(0.3);
  EXPECT_FALSE(drag(editor, scenario, {2, 1}, {2, 1}).has_value());
  EXPECT_TRUE(editor.can_finish()) << "a person may stand";
  editor.move({4, 1});
  ASSERT_TRUE(editor.preview(scenario).person.has_value());
  EXPECT_EQ(editor.preview(scenario).person->route.back(), mrpt::math::TPoint2D(4, 1));
  EXPECT_FALSE(drag(editor, scenario, {4, 1}, {4, 1}).has_value());
  EXPECT_FALSE(drag(editor, scenario, {4, 2}, {4, 2}).has_value());
  const auto edit = editor.finish(scenario);
  ASSERT_TRUE(edit.has_value());
  EXPECT_EQ(edit->title, "Add person");
  const Person expected{"person_1", 0.3, 1.3, {2, 1}, {{4, 1}, {4, 2}}};
  EXPECT_EQ(edit->scenario.people(), People{expected});
  EXPECT_FALSE(editor.busy());
}

TEST(SceneEditor, LetsAPersonReturnWhoseRouteEndsAtItsStart) {
  SceneEditor editor;
  editor.set_tool(EditTool::Person);
  for (const auto& point : {mrpt::math::TPoint2D(2, 1), {4, 1}})
    EXPECT_FALSE(drag(editor, room(), point, point).has_value());
  const auto edit = drag(editor, room(), {2.05, 1}, {2.05, 1});
  ASSERT_TRUE(edit.has_value());
  const Person expected{"person_1", 0.25, 1, {2, 1}, {{4, 1}}, 0, PersonEnd::Return};
  EXPECT_EQ(edit->scenario.people(), People{expected});
}

TEST(SceneEditor, MovesStartAndRouteOfPeopleAndDeletesThem) {
  const Scenario scenario = room().with_people({{"a", 0.4, 1, {2, 1}, {{4, 1}, {6, 1}}}});
  SceneEditor editor;
  editor.set_tool(EditTool::Move);
  const auto start = drag(editor, scenario, {2.3, 1}, {2.3, 2});
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->title, "Move start of a person");
  EXPECT_EQ(start->scenario.people()[0].start, mrpt::math::TPoint2D(2, 2));
  EXPECT_EQ(start->scenario.people()[0].route, scenario.people()[0].route);
  const auto point = drag(editor, scenario, {4.05, 1}, {4.05, 2});
  ASSERT_TRUE(point.has_value());
  EXPECT_EQ(point->title, "Move point of a route");
  EXPECT_EQ(point->scenario.people()[0].route[0], mrpt::math::TPoint2D(4, 2));
  EXPECT_EQ(drag(editor, scenario, {5, 3}, {5, 4})->title, "Move obstacle");
  editor.set_tool(EditTool::Delete);
  const auto deleted = drag(editor, scenario, {6, 1}, {6, 1});
  ASSERT_TRUE(deleted.has_value());
  EXPECT_EQ(deleted->title, "Delete person");
  EXPECT_EQ(deleted->scenario.hash(), room().hash());
}

TEST(SceneEditor, RefusesChangedPeopleWhoStartInAWall) {
  const Person in_wall{"in", 0.3, 1, {0.2, 1}, {{4, 1}}}, free{"free", 0.3, 1, {2, 1}, {{4, 1}}};
  const World before(room().with_people({in_wall}), 0.05);
  EXPECT_NO_THROW(check_edited_people(before, room().with_people({in_wall, free})));
  EXPECT_TRUE(throws_error(ErrorKind::File, "room: person 'in'", {"starts in a wall"}, [&] {
    check_edited_people(World(room(), 0.05), room().with_people({in_wall}));
  }));
}

}  // namespace
}  // namespace slalom
