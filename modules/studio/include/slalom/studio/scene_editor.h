#pragma once

#include <slalom/commands/edit_geometry.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The effect of clicking and dragging in the view.
enum class EditTool { Look, Start, Goal, Disc, Polygon, Move, Delete, Paint, Erase };

struct EditToolInfo {
  EditTool tool;
  std::string id;     ///< "disc"
  std::string title;  ///< "Add disc"
  char key;           ///< shortcut while the view has the focus
  std::string help;   ///< how to use it
};
const std::vector<EditToolInfo>& edit_tools();
const EditToolInfo& info_of(EditTool tool);
/// Why the tool is not applicable to such scenarios; empty if it is.
std::string tool_disabled_reason(EditTool tool, Representation representation);

/// An edited scenario with a title of the edit, e.g. "Move goal".
struct SceneEdit {
  Scenario scenario;
  std::string title;
};

/// Preview of the current edit; drawn over the scene.
struct EditPreview {
  std::optional<mrpt::math::TPose2D> start;
  std::optional<mrpt::math::TPoint2D> goal;
  Primitives obstacles;                            ///< added or moved
  std::vector<mrpt::math::TPoint2D> open_polygon;  ///< vertices so far and the pointer position
  Stroke stroke;                                   ///< of the brush; none if it has no points
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

  /// `tolerance` (m) is the maximum distance at which a press hits an obstacle or vertex, and the
  /// minimum length of a drag.
  void press(const Scenario& scenario, const mrpt::math::TPoint2D& at, double tolerance);
  void move(const mrpt::math::TPoint2D& at);
  /// Returns the edit that is completed by the release, if any. Throws Error (Usage) if it is
  /// invalid; the edit is canceled then.
  std::optional<SceneEdit> release(const Scenario& scenario, const mrpt::math::TPoint2D& at);
  /// Closes a polygon of three or more vertices. Throws as release() does.
  std::optional<SceneEdit> finish(const Scenario& scenario);
  void cancel();

  bool pressed() const { return pressed_; }
  bool busy() const { return pressed_ || !vertices_.empty(); }  ///< an edit is in progress
  EditPreview preview(const Scenario& scenario) const;

 private:
  mrpt::math::TPose2D start_pose(const Scenario& scenario) const;
  Disc new_disc() const;
  bool dragged() const;
  std::optional<SceneEdit> edit(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_obstacle(const Scenario& scenario) const;
  std::optional<SceneEdit> edit_cells(const Scenario& scenario) const;
  std::optional<SceneEdit> add_vertex(const Scenario& scenario);

  EditTool tool_ = EditTool::Look;
  double brush_ = 0.25, tolerance_ = 0;
  bool pressed_ = false;
  mrpt::math::TPoint2D from_, at_;
  std::optional<std::size_t> obstacle_;  ///< the pressed obstacle
  std::vector<mrpt::math::TPoint2D> stroke_, vertices_;
};

}  // namespace slalom
