// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/commands/edit_geometry.h>
#include <slalom/commands/edit_movers.h>
#include <slalom/commands/edit_people.h>
#include <slalom/scenario/world.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The effect of clicking and dragging in the view.
enum class EditTool { Look, Start, Goal, Disc, Polygon, Mover, Person, Move, Delete, Paint, Erase };

struct EditToolInfo {
  EditTool tool;
  std::string id;     ///< "disc"
  std::string title;  ///< "Add disc"
  char key;           ///< shortcut while the view has the focus
  std::string help;   ///< how to use it
};
const std::vector<EditToolInfo>& edit_tools();
const EditToolInfo& info_of(EditTool tool);
/// Why the tool is not applicable to the scenario; empty if it is.
std::string tool_disabled_reason(EditTool tool, const Scenario& scenario);

/// An edited scenario with a title of the edit, e.g. "Move goal".
struct SceneEdit {
  Scenario scenario;
  std::string title;
};

/// Refuses an edit of people that a run would refuse: throws as check_people() of a world does for
/// those who are not in the scenario of `world`. The edited scenario has the static obstacles of
/// `world` unless there are none of these.
void check_edited_people(const World& world, const Scenario& edited);

/// A goal, and the heading (rad) of the robot there if there is one.
struct EditedGoal {
  mrpt::math::TPoint2D position;
  std::optional<double> heading;
};

/// Preview of the current edit; drawn over the scene.
struct EditPreview {
  std::optional<mrpt::math::TPose2D> start;
  std::optional<EditedGoal> goal;
  Primitives obstacles;                            ///< added or moved
  std::vector<mrpt::math::TPoint2D> open_polygon;  ///< vertices so far and the pointer position
  Stroke stroke;                                   ///< of the brush; none if it has no points
  std::optional<Mover> mover;                      ///< added or moved
  std::optional<Person> person;                    ///< added or moved
};

/// Converts presses, drags and releases at world positions (m) into edits, from mouse or keyboard.
/// Independent of the window.
class SceneEditor {
 public:
  EditTool tool() const { return tool_; }
  void set_tool(EditTool tool);  ///< cancels the current edit
  double brush() const { return brush_; }
  /// Radius (m) of the brush and of discs that are added by a click. Clamped to 0.001 ... 100 m.
  void set_brush(double radius);
  double speed() const { return speed_; }
  /// Speed (m/s) of movers and people whose way is drawn. Clamped to 0.01 ... 100 m/s.
  void set_speed(double speed);

  /// `tolerance` (m) is the maximum distance at which a press hits an obstacle or vertex, and the
  /// minimum length of a drag. Movers are hit where they are at `time` (s of a run), people where
  /// they start.
  void press(const Scenario& scenario, const mrpt::math::TPoint2D& at, double tolerance,
             double time = 0);
  void move(const mrpt::math::TPoint2D& at);
  /// Returns the edit that is completed by the release, if any. Throws Error (Usage) if it is
  /// invalid; the edit is canceled then.
  std::optional<SceneEdit> release(const Scenario& scenario, const mrpt::math::TPoint2D& at);
  /// Whether finish() completes an edit.
  bool can_finish() const;
  /// Closes a polygon of three or more vertices, or ends the path of a mover or a person. Throws as
  /// release() does.
  std::optional<SceneEdit> finish(const Scenario& scenario);
  void cancel();

  bool pressed() const { return pressed_; }
  bool busy() const { return pressed_ || !vertices_.empty(); }  ///< an edit is in progress
  EditPreview preview(const Scenario& scenario) const;

 private:
  mrpt::math::TPose2D start_pose(const Scenario& scenario) const;
  EditedGoal goal(const Scenario& scenario) const;
  Disc new_disc() const;
  bool dragged() const;
  std::optional<SceneEdit> edit(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_obstacle(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_cells(const Scenario& scenario) const;
  std::optional<SceneEdit> add_vertex(const Scenario& scenario);
  bool draws_way() const;
  void pick_moving(const Scenario& scenario, double time);
  Mover dragged_mover(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_mover(const Scenario& scenario) const;
  Person dragged_person(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_person(const Scenario& scenario) const;

  EditTool tool_ = EditTool::Look;
  double brush_ = 0.25, speed_ = 1, tolerance_ = 0;
  bool pressed_ = false;
  mrpt::math::TPoint2D from_, at_;
  std::optional<std::size_t> obstacle_;  ///< the pressed obstacle
  std::optional<std::size_t> mover_;     ///< the pressed mover, at its disc or at a waypoint
  std::optional<std::size_t> waypoint_;  ///< of that mover, if its disc was not pressed
  std::optional<StationIndex> station_;  ///< the pressed one of a person
  std::vector<mrpt::math::TPoint2D> stroke_, vertices_;
};

}  // namespace slalom
