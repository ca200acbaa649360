#pragma once

#include <slalom/commands/edit_geometry.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What pressing and dragging in the view does.
enum class EditTool { Look, Start, Goal, Disc, Polygon, Move, Delete, Paint, Erase };

struct EditToolInfo {
  EditTool tool;
  std::string id;     ///< "disc"
  std::string title;  ///< "Add disc"
  char key;           ///< that chooses it while the view has the keyboard
  std::string help;   ///< how to use it
};
const std::vector<EditToolInfo>& edit_tools();
const EditToolInfo& info_of(EditTool tool);
/// Why it is of no use for such scenarios; empty when it is.
std::string obstacle_to(EditTool tool, Representation representation);

/// An edited scenario with what was done to it, e.g. "Move goal".
struct SceneEdit {
  Scenario scenario;
  std::string title;
};

/// What an edit would change if it ended now; drawn over the scene.
struct EditPreview {
  std::optional<mrpt::math::TPose2D> start;
  std::optional<mrpt::math::TPoint2D> goal;
  Primitives obstacles;                            ///< added or moved
  std::vector<mrpt::math::TPoint2D> open_polygon;  ///< vertices so far and the place of the mouse
  Stroke stroke;                                   ///< of the brush; no points: none
};

/// Turns presses, drags and releases at places of the world (m) into edits, whichever of mouse and
/// keyboard they come from. Knows no window.
class SceneEditor {
 public:
  EditTool tool() const { return tool_; }
  void set_tool(EditTool tool);  ///< what was begun is dropped
  double brush() const { return brush_; }
  /// Radius of the brush, and of a disc that is added by a click (m). Between 1 mm and 100 m.
  void set_brush(double radius);

  /// `tolerance` (m) is how far beside something a press still means it, and how far a drag must
  /// go to be one.
  void press(const Scenario& scenario, const mrpt::math::TPoint2D& at, double tolerance);
  void move(const mrpt::math::TPoint2D& at);
  /// The edit that this ends, if it ends one. Throws Error (Usage) when it is impossible; what was
  /// begun is dropped then, too.
  std::optional<SceneEdit> release(const Scenario& scenario, const mrpt::math::TPoint2D& at);
  /// Closes a polygon of three or more vertices. Throws as release() does.
  std::optional<SceneEdit> finish(const Scenario& scenario);
  void cancel();

  bool pressed() const { return pressed_; }
  bool busy() const { return pressed_ || !vertices_.empty(); }  ///< something was begun
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
  std::optional<std::size_t> obstacle_;  ///< that was pressed on
  std::vector<mrpt::math::TPoint2D> stroke_, vertices_;
};

}  // namespace slalom
