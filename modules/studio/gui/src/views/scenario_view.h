// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "views/scene_layers.h"
#include "views/view_layout.h"
#include "widgets/element.h"

#include <slalom/studio/scene_editor.h>
#include <slalom/studio/studio.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Displays the current scenario to scale, in layers, and edits it. Element "view" with the parts
/// of ViewLayout, "canvas", "status", "scale bar", "color bar", and positions in the world:
/// "at X Y" (m), "start", "goal", "mover ID", "person ID".
///
/// Mouse: the wheel zooms, a drag pans the view (also with the left button while the tool is Look);
/// shift and the wheel, or shift and a drag, rotate the scan. Keys: arrows pan the view, with shift
/// they move the pointer, whose button is Enter; + - 0 zoom and fit; 1 to 9 toggle layers, L the
/// legend; C colors runs otherwise; Q and W rotate the scan, comma and period change the brush, T
/// and Y the speed of movers and people; a letter for each tool; Escape cancels the current edit.
class ScenarioView : public Element {
 public:
  enum class Mode { Look, Edit };  ///< without and with editing tools
  ScenarioView(nanogui::Widget* parent, Studio& studio, Mode mode);

  /// Null displays a message instead. Keeps the visible area if the new scene has the same bounds;
  /// otherwise fits the scene. Also called after a change of the studio's.
  void set_scene(ScenePtr scene);
  const ScenePtr& scene() const { return scene_; }
  const std::vector<SceneLayer>& layers() const { return layers_; }
  /// Throws Error (Usage), listing the layers, if the id is unknown.
  bool layer_on(const std::string& id) const;
  void set_layer(const std::string& id, bool on);
  bool legend_open() const { return legend_open_; }
  void set_legend_open(bool open);

  EditTool tool() const { return editor_.tool(); }
  /// Displays a message instead if the tool is not applicable to this scenario.
  void set_tool(EditTool tool);
  void rotate_scan(double angle);  ///< by `angle` (rad)

  void fit();
  void zoom(double factor);        ///< about the center
  void pan(double dx, double dy);  ///< pixels

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;

 protected:
  void paint(NVGcontext* ctx) override;
  void drag(const Point& at) override { pointer_moved(at); }
  void hover(const std::optional<Point>& at) override;
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;

 private:
  static constexpr double kMaxScaleBar = 140;  ///< pixels

  const SceneLayer& layer(const std::string& id) const;
  ViewLayout make_layout() const;
  ViewTransform view_on(const ViewLayout& layout) const;
  void adjust_to_size();

  void pointer_moved(const Point& at);  ///< pixels
  void activate_part(std::string name);
  void press_tool();    ///< at the pointer, by mouse or keyboard
  void release_tool();  ///< at the pointer, by mouse or keyboard
  template <typename End>
  void end_edit(End end);
  bool tool_key(int key);
  bool layer_key(int key);
  bool view_key(int key, int modifiers);
  bool edit_key(int key);
  void move_pointer(double dx, double dy);

  double time() const;    ///< s of a run, at which movers are shown
  Movers people() const;  ///< of the scene, as they move
  std::optional<mrpt::math::TPose2D> scan_pose() const;
  std::optional<double> clearance_at_pointer() const;
  /// The sample of a run at the pointer.
  std::optional<ResultsOverlay::RunSample> sample_at_pointer() const;
  std::string color_bar_text() const;  ///< "speed 0.00 to 0.98 m/s"; empty for none
  ScreenRect color_bar_rect() const;
  std::string status_text() const;
  std::string pointer_text() const;
  std::string layer_line(const SceneLayer& layer) const;

  void draw_scene(NVGcontext* ctx);
  void draw_background(const LayerContext& context);
  void draw_border(NVGcontext* ctx) const;
  void draw_preview(NVGcontext* ctx) const;
  void draw_pointer(NVGcontext* ctx) const;
  void draw_scale_bar(NVGcontext* ctx) const;
  void draw_color_bar(NVGcontext* ctx) const;
  void draw_sample(NVGcontext* ctx) const;
  void draw_tools(NVGcontext* ctx) const;
  void draw_legend(NVGcontext* ctx) const;
  void draw_row(NVGcontext* ctx, const ScreenRect& rect, const SceneLayer& layer) const;
  std::string note_of(const SceneLayer& layer) const;
  double measure_legend(NVGcontext* ctx) const;
  void draw_status(NVGcontext* ctx) const;

  Studio& studio_;
  Mode mode_;
  ScenePtr scene_;
  std::vector<OverlayTrajectory> trajectories_;
  std::vector<SceneLayer> layers_;
  TileImages tiles_;
  bool legend_open_ = true;
  double legend_width_ = ViewLayout::kLegendWidth;  ///< pixels that the texts of a row need

  ViewLayout layout_;
  ViewTransform view_;
  bool fitted_ = true;  ///< the scene is fitted, also after resizing

  SceneEditor editor_;
  std::optional<Point> pointer_;   ///< m
  Point last_;                     ///< pixels, of the pointer
  bool keyboard_pointer_ = false;  ///< moved by keys: drawn as a cross
  std::string hovered_;            ///< part under the mouse
  bool panning_ = false;
  std::optional<Point> scan_anchor_;  ///< position of the scan while its heading is dragged
  double heading_ = 0;
  std::string error_;  ///< error message of the last edit
};

}  // namespace slalom
