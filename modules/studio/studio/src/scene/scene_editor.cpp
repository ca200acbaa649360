// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/people/crowd.h>
#include <slalom/studio/scene_editor.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

/// Obstacle number `index`, translated.
Primitives translated(const Primitives& all, std::size_t index, double dx, double dy) {
  Primitives result;
  if (index < all.discs.size()) {
    const Disc& disc = all.discs[index];
    result.discs.push_back({{disc.center.x + dx, disc.center.y + dy}, disc.radius});
  } else if (index - all.discs.size() < all.polygons.size()) {
    Polygon polygon = all.polygons[index - all.discs.size()];
    for (TPoint2D& p : polygon.vertices) p = {p.x + dx, p.y + dy};
    result.polygons.push_back(std::move(polygon));
  }
  return result;
}

}  // namespace

const std::vector<EditToolInfo>& edit_tools() {
  static const std::vector<EditToolInfo> tools = {
      {EditTool::Look, "look", "Look", 'V', "drag moves the view, the wheel zooms"},
      {EditTool::Start, "start", "Start", 'S',
       "press at the start position, drag to set the heading"},
      {EditTool::Goal, "goal", "Goal", 'G',
       "press at the goal position, drag to set a heading there; a click on the goal removes it"},
      {EditTool::Disc, "disc", "+ Disc", 'D', "press at the center, drag the radius"},
      {EditTool::Polygon, "polygon", "+ Polygon", 'P',
       "click the corners; click the first again or press Enter to close it"},
      {EditTool::Mover, "mover", "+ Mover", 'O',
       "click the path; Enter ends it, a click on its start closes it; < and > radius, T and Y "
       "speed"},
      {EditTool::Person, "person", "+ Person", 'H',
       "click start and route; Enter ends it, a click on the start returns; < and > radius, T and "
       "Y speed"},
      {EditTool::Move, "move", "Move", 'M',
       "drag an obstacle, a waypoint, or the start or route of a person"},
      {EditTool::Delete, "delete", "Delete", 'X', "click an obstacle or a person"},
      {EditTool::Paint, "paint", "Paint", 'B', "drag to add obstacles; < and > change the brush"},
      {EditTool::Erase, "erase", "Erase", 'E',
       "drag to remove obstacles; < and > change the brush"}};
  return tools;
}

const EditToolInfo& info_of(EditTool tool) {
  return *std::find_if(edit_tools().begin(), edit_tools().end(),
                       [tool](const EditToolInfo& info) { return info.tool == tool; });
}

std::string tool_disabled_reason(EditTool tool, const Scenario& scenario) {
  const Representation representation = scenario.representation();
  const bool cells = tool == EditTool::Paint || tool == EditTool::Erase;
  const bool of_moving = (tool == EditTool::Move || tool == EditTool::Delete) &&
                         !(scenario.movers().empty() && scenario.people().empty());
  const bool obstacles = !of_moving && (tool == EditTool::Disc || tool == EditTool::Polygon ||
                                        tool == EditTool::Move || tool == EditTool::Delete);
  if (representation == Representation::Continuous && cells)
    return "this scenario consists of discs and polygons, not of cells or points";
  if (representation != Representation::Continuous && obstacles)
    return std::string("this scenario consists of ") +
           (representation == Representation::Grid ? "cells" : "points") + "; paint or erase them";
  return "";
}

void check_edited_people(const World& world, const Scenario& edited) {
  const People& before = world.scenario().people();
  People changed;
  for (const Person& person : edited.people())
    if (std::find(before.begin(), before.end(), person) == before.end()) changed.push_back(person);
  if (!changed.empty()) check_people(world, changed);
}

void SceneEditor::set_tool(EditTool tool) {
  cancel();
  tool_ = tool;
}

void SceneEditor::set_brush(double radius) {
  brush_ = std::clamp(radius, 0.001, 100.0);
}

void SceneEditor::set_speed(double speed) {
  speed_ = std::clamp(speed, 0.01, 100.0);
}

void SceneEditor::press(const Scenario& scenario, const TPoint2D& at, double tolerance,
                        double time) {
  if (tool_ == EditTool::Look) return;
  pressed_ = true;
  tolerance_ = tolerance;
  from_ = at_ = at;
  stroke_ = {at};
  obstacle_ = obstacle_at(scenario, at, tolerance);
  pick_moving(scenario, time);
}

/// The discs of movers come before waypoints, which may be below them, and these before people.
void SceneEditor::pick_moving(const Scenario& scenario, double time) {
  mover_ = mover_at(scenario, at_, time);
  waypoint_.reset();
  station_.reset();
  if (mover_) return;
  const auto waypoint = waypoint_at(scenario, at_, tolerance_);
  if (!waypoint) {
    station_ = station_at(scenario, at_, tolerance_);
    return;
  }
  mover_ = waypoint->mover;
  waypoint_ = waypoint->waypoint;
}

void SceneEditor::move(const TPoint2D& at) {
  at_ = at;
  // Points closer than a quarter of the brush make no visible difference.
  if (pressed_ && distance_between(stroke_.back(), at) > std::max(0.25 * brush_, 1e-6))
    stroke_.push_back(at);
}

std::optional<SceneEdit> SceneEditor::release(const Scenario& scenario, const TPoint2D& at) {
  if (!pressed_) return std::nullopt;
  at_ = at;
  if (!(stroke_.back() == at)) stroke_.push_back(at);
  pressed_ = false;
  if (tool_ == EditTool::Polygon || draws_way()) return add_vertex(scenario);
  return edit(scenario);
}

bool SceneEditor::draws_way() const {
  return tool_ == EditTool::Mover || tool_ == EditTool::Person;
}

std::optional<SceneEdit> SceneEditor::add_vertex(const Scenario& scenario) {
  const bool at_first =
      !vertices_.empty() && distance_between(vertices_.front(), at_) <= tolerance_;
  if (draws_way() && vertices_.size() >= 2 && at_first) vertices_.push_back(vertices_.front());
  if (vertices_.size() >= 3 && at_first) return finish(scenario);
  if (vertices_.empty() || distance_between(vertices_.back(), at_) > tolerance_)
    vertices_.push_back(at_);
  return std::nullopt;
}

bool SceneEditor::can_finish() const {
  return vertices_.size() >= (draws_way() ? 1 : 3);
}

std::optional<SceneEdit> SceneEditor::finish(const Scenario& scenario) {
  if (!can_finish()) return std::nullopt;
  if (tool_ == EditTool::Mover) {
    const Mover mover = mover_along(std::exchange(vertices_, {}), brush_, speed_);
    return SceneEdit{with_mover_added(scenario, mover), "Add moving obstacle"};
  }
  if (tool_ == EditTool::Person) {
    const Person person = person_along(std::exchange(vertices_, {}), brush_, speed_);
    return SceneEdit{with_person_added(scenario, person), "Add person"};
  }
  const Polygon polygon{std::exchange(vertices_, {})};
  return SceneEdit{with_obstacle_added(scenario, polygon), "Add polygon"};
}

void SceneEditor::cancel() {
  pressed_ = false;
  vertices_.clear();
  stroke_.clear();
  obstacle_.reset();
  mover_.reset();
  station_.reset();
}

bool SceneEditor::dragged() const {
  return distance_between(from_, at_) > tolerance_;
}

/// A drag sets the heading of the robot; a click keeps it.
TPose2D SceneEditor::start_pose(const Scenario& scenario) const {
  const double heading =
      dragged() ? math::atan2(at_.y - from_.y, at_.x - from_.x) : scenario.start().phi;
  return {from_.x, from_.y, heading};
}

/// A drag sets a heading of the goal; a click keeps it, and on the goal removes it.
EditedGoal SceneEditor::goal(const Scenario& scenario) const {
  if (dragged()) return {from_, math::atan2(at_.y - from_.y, at_.x - from_.x)};
  const bool on_goal = distance_between(from_, scenario.goal()) <= tolerance_;
  if (on_goal && scenario.goal_heading()) return {scenario.goal(), std::nullopt};
  return {from_, scenario.goal_heading()};
}

Disc SceneEditor::new_disc() const {
  return {from_, dragged() ? distance_between(from_, at_) : brush_};
}

std::optional<SceneEdit> SceneEditor::edit(const Scenario& scenario) const {
  switch (tool_) {
    case EditTool::Start:
      return SceneEdit{with_start(scenario, start_pose(scenario)), "Move start"};
    case EditTool::Goal: {
      const EditedGoal edited = goal(scenario);
      return SceneEdit{with_goal(scenario, edited.position).with_goal_heading(edited.heading),
                       "Move goal"};
    }
    case EditTool::Disc:
      return SceneEdit{with_obstacle_added(scenario, new_disc()), "Add disc"};
    case EditTool::Move:
    case EditTool::Delete:
      return edit_obstacle(scenario);
    case EditTool::Paint:
    case EditTool::Erase:
      return edit_cells(scenario);
    case EditTool::Look:
    case EditTool::Polygon:
    case EditTool::Mover:
    case EditTool::Person:
      break;
  }
  return std::nullopt;
}

Mover SceneEditor::dragged_mover(const Scenario& scenario) const {
  const Mover& mover = scenario.movers().at(*mover_);
  const double dx = at_.x - from_.x, dy = at_.y - from_.y;
  return waypoint_ ? with_waypoint_moved(mover, *waypoint_, dx, dy) : moved(mover, dx, dy);
}

std::optional<SceneEdit> SceneEditor::edit_mover(const Scenario& scenario) const {
  if (tool_ == EditTool::Delete)
    return SceneEdit{with_mover_removed(scenario, *mover_), "Delete moving obstacle"};
  if (!dragged()) return std::nullopt;
  return SceneEdit{with_mover_replaced(scenario, *mover_, dragged_mover(scenario)),
                   waypoint_ ? "Move waypoint" : "Move moving obstacle"};
}

Person SceneEditor::dragged_person(const Scenario& scenario) const {
  return with_station_moved(scenario.people().at(station_->person), station_->station,
                            at_.x - from_.x, at_.y - from_.y);
}

std::optional<SceneEdit> SceneEditor::edit_person(const Scenario& scenario) const {
  if (tool_ == EditTool::Delete)
    return SceneEdit{with_person_removed(scenario, station_->person), "Delete person"};
  if (!dragged()) return std::nullopt;
  return SceneEdit{with_person_replaced(scenario, station_->person, dragged_person(scenario)),
                   station_->station == 0 ? "Move start of a person" : "Move point of a route"};
}

std::optional<SceneEdit> SceneEditor::edit_obstacle(const Scenario& scenario) const {
  if (mover_) return edit_mover(scenario);
  if (station_) return edit_person(scenario);
  if (!obstacle_) return std::nullopt;
  if (tool_ == EditTool::Delete)
    return SceneEdit{with_obstacle_removed(scenario, *obstacle_), "Delete obstacle"};
  if (!dragged()) return std::nullopt;
  return SceneEdit{with_obstacle_moved(scenario, *obstacle_, at_.x - from_.x, at_.y - from_.y),
                   "Move obstacle"};
}

std::optional<SceneEdit> SceneEditor::edit_cells(const Scenario& scenario) const {
  const bool paint = tool_ == EditTool::Paint;
  if (scenario.representation() == Representation::Points) {
    if (paint) return SceneEdit{with_points_added(scenario, stroke_), "Add points"};
    return SceneEdit{with_points_removed(scenario, {stroke_, brush_}), "Delete points"};
  }
  return SceneEdit{with_cells_painted(scenario, {stroke_, brush_}, paint),
                   paint ? "Paint cells" : "Erase cells"};
}

EditPreview SceneEditor::preview(const Scenario& scenario) const {
  EditPreview preview;
  if (!vertices_.empty()) {
    preview.open_polygon = vertices_;
    preview.open_polygon.push_back(at_);
    if (tool_ == EditTool::Mover)
      preview.mover = mover_along(std::exchange(preview.open_polygon, {}), brush_, speed_);
    if (tool_ == EditTool::Person)
      preview.person = person_along(std::exchange(preview.open_polygon, {}), brush_, speed_);
  }
  if (!pressed_) return preview;
  if (tool_ == EditTool::Start) preview.start = start_pose(scenario);
  if (tool_ == EditTool::Goal) preview.goal = goal(scenario);
  if (tool_ == EditTool::Disc) preview.obstacles.discs.push_back(new_disc());
  if (tool_ == EditTool::Move && mover_)
    preview.mover = dragged_mover(scenario);
  else if (tool_ == EditTool::Move && station_)
    preview.person = dragged_person(scenario);
  else if (tool_ == EditTool::Move && obstacle_)
    preview.obstacles =
        translated(scenario.primitives(), *obstacle_, at_.x - from_.x, at_.y - from_.y);
  if (tool_ == EditTool::Paint || tool_ == EditTool::Erase) preview.stroke = {stroke_, brush_};
  return preview;
}

}  // namespace slalom
