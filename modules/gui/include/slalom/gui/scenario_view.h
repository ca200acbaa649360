#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/scene_editor.h>
#include <slalom/gui/scene_layers.h>
#include <slalom/gui/view_layout.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The current scenario to scale, in layers, to look at and to edit. Element "view" with the parts
/// of ViewLayout, "canvas", "status", "scale bar", and places of the world as "at X Y" (m),
/// "start", "goal".
///
/// Mouse: the wheel zooms, a drag moves the view (with the left button, too, while the tool is to
/// look); shift and the wheel, or shift and a drag, turn the scan. Keys: arrows move the view, with
/// shift the pointer, which Enter presses and releases; + - 0 zoom and fit; 1 to 9 switch layers,
/// L the legend; Q and W turn the scan, comma and period change the brush; a letter of each tool;
/// Escape takes back what was begun.
class ScenarioView : public Element {
 public:
  explicit ScenarioView(nanogui::Widget* parent);

  /// The user has edited the scenario that is shown. It stays as it is until set_scene(). Where
  /// nobody listens there are no tools.
  std::function<void(const SceneEdit&)> on_edit;
  /// Layers were switched or the legend opened or closed.
  std::function<void()> on_layers;

  /// Null shows the message instead. The same place is looked at when the new scene has the same
  /// bounds; otherwise all of it.
  void set_scene(ScenePtr scene);
  const ScenePtr& scene() const { return scene_; }
  void set_message(std::string message) { message_ = std::move(message); }
  void set_trajectories(std::vector<OverlayTrajectory> runs) { trajectories_ = std::move(runs); }

  const SceneLayers& layers() const { return layers_; }
  /// Throws Error (Usage) naming the layers when there is none of that id.
  bool layer_on(const std::string& id) const;
  void set_layer(const std::string& id, bool on);
  bool legend_open() const { return legend_open_; }
  void set_legend_open(bool open);

  EditTool tool() const { return editor_.tool(); }
  /// Ends in a message when the tool is of no use for this scenario.
  void set_tool(EditTool tool);
  double scan_heading() const { return heading_; }  ///< rad
  void turn_scan(double angle);                     ///< by so much (rad)

  const ViewTransform& transform() const { return view_; }
  void fit();
  void zoom(double factor);        ///< about the middle
  void pan(double dx, double dy);  ///< pixels

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  static constexpr double kLongestScaleBar = 140;  ///< pixels

  using Point = mrpt::math::TPoint2D;

  SceneLayer& layer(const std::string& id) const;
  ViewLayout make_layout() const;
  ViewTransform view_on(const ViewLayout& layout) const;
  void adjust_to_size();
  Point local(const nanogui::Vector2i& p) const;

  void moved_to(const Point& at, const Point& by, int buttons);
  void choose_part(std::string name);
  void press();    ///< at the pointer, with mouse or keyboard
  void release();  ///< the same
  template <typename End>
  void end_edit(End end);
  bool tool_key(int key);
  bool layer_key(int key);
  bool view_key(int key, int modifiers);
  bool edit_key(int key);
  void move_pointer(double dx, double dy);

  std::optional<mrpt::math::TPose2D> scan_pose() const;
  std::optional<double> clearance_at_pointer() const;
  std::string status_text() const;
  std::string pointer_text() const;
  std::string layer_line(const SceneLayer& layer) const;

  void draw_scene(NVGcontext* ctx);
  void draw_ground(const LayerContext& context);
  void draw_preview(NVGcontext* ctx) const;
  void draw_pointer(NVGcontext* ctx) const;
  void draw_scale_bar(NVGcontext* ctx) const;
  void draw_tools(NVGcontext* ctx) const;
  void draw_legend(NVGcontext* ctx) const;
  void draw_row(NVGcontext* ctx, const ScreenRect& rect, const SceneLayer& layer) const;
  void draw_status(NVGcontext* ctx) const;

  ScenePtr scene_;
  std::string message_ = "No scenario is chosen";
  std::vector<OverlayTrajectory> trajectories_;
  SceneLayers layers_;
  TileImages tiles_;
  bool legend_open_ = true;

  ViewLayout layout_;
  ViewTransform view_;
  bool fitted_ = true;  ///< all is shown, also when the size changes

  SceneEditor editor_;
  std::optional<Point> pointer_;   ///< m
  bool keyboard_pointer_ = false;  ///< it was moved by keys: a cross is drawn there
  std::string hovered_;            ///< part under the mouse
  bool panning_ = false;
  std::optional<Point> scan_pin_;  ///< while its heading is dragged
  double heading_ = 0;
  std::string refusal_;  ///< of the last edit
};

}  // namespace slalom
