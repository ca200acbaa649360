// SPDX-License-Identifier: BSD-3-Clause
#include "views/scenario_view.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kRotateStep = 5 * M_PI / 180;  ///< rad
constexpr double kPanStep = 40;                 ///< pixels
constexpr double kPointerStep = 10;             ///< pixels
constexpr double kTolerance = 6;                ///< pixels

}  // namespace

bool ScenarioView::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                    int modifiers) {
  const Point at = local(p);
  if (!down) {
    panning_ = false;
    scan_anchor_.reset();
    if (button == GLFW_MOUSE_BUTTON_LEFT) release_tool();
    return true;
  }
  requestFocus();
  adjust_to_size();
  pointer_moved(at);
  if (const Element::Part* part = layout_.at(at.x, at.y)) {
    if (button == GLFW_MOUSE_BUTTON_LEFT) activate_part(part->name);
    return true;
  }
  if (!scene_ || !layout_.canvas.contains(at.x, at.y)) return true;
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  if (button == GLFW_MOUSE_BUTTON_LEFT && shift && layer_on("scan"))
    scan_anchor_ = pointer_;
  else if (button != GLFW_MOUSE_BUTTON_LEFT || tool() == EditTool::Look)
    panning_ = true;
  else
    press_tool();
  return true;
}

void ScenarioView::hover(const std::optional<Point>& at) {
  if (at) return pointer_moved(*at);
  hovered_.clear();
  if (!editor_.busy() && !keyboard_pointer_) pointer_.reset();
}

void ScenarioView::pointer_moved(const Point& at) {
  const Element::Part* part = layout_.at(at.x, at.y);
  hovered_ = part != nullptr ? part->name : "";
  if (panning_) pan(at.x - last_.x, at.y - last_.y);
  last_ = at;
  if (!scene_) return;
  const bool busy = panning_ || scan_anchor_ || editor_.busy();
  if (!busy && (part != nullptr || !layout_.canvas.contains(at.x, at.y))) {
    if (!keyboard_pointer_) pointer_.reset();
    return;
  }
  keyboard_pointer_ = false;
  pointer_ = view_.to_world(at);
  if (scan_anchor_ && math::hypot(pointer_->x - scan_anchor_->x, pointer_->y - scan_anchor_->y) *
                              view_.pixels_per_meter() >
                          kTolerance)
    heading_ = math::atan2(pointer_->y - scan_anchor_->y, pointer_->x - scan_anchor_->x);
  editor_.move(*pointer_);
}

/// Takes its argument by value: the action may rebuild the layout and so invalidate a reference to
/// the part's name.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void ScenarioView::activate_part(const std::string name) {
  if (name == "legend") set_legend_open(!legend_open_);
  if (name == "zoom in") zoom(kZoomStep);
  if (name == "zoom out") zoom(1 / kZoomStep);
  if (name == "fit") fit();
  for (const EditToolInfo& info : edit_tools())
    if (name == "tool " + info.id) set_tool(info.tool);
  for (const auto& layer : layers_)
    if (name == "layer " + layer.id) return set_layer(layer.id, !layer.on);
}

void ScenarioView::press_tool() {
  error_.clear();
  if (scene_ && pointer_)
    editor_.press(scene_->scenario(), *pointer_, kTolerance / view_.pixels_per_meter(), time());
}

void ScenarioView::release_tool() {
  if (!scene_ || !pointer_) return editor_.cancel();
  end_edit([this] { return editor_.release(scene_->scenario(), *pointer_); });
}

/// Passes the edit to the studio, or shows the error.
template <typename End>
void ScenarioView::end_edit(End end) {
  try {
    const std::optional<SceneEdit> edit = end();
    if (!edit || mode_ != Mode::Edit) return;
    check_edited_people(*scene_->world, edit->scenario);
    studio_.edit_current(*edit);
  } catch (const Error& e) {
    error_ = e.what();
  }
}

bool ScenarioView::wheel(const Point& at, double steps) {
  if (!scene_ || !layout_.canvas.contains(at)) return true;
  // Scroll events have no modifiers.
  GLFWwindow* window = screen()->glfwWindow();
  const bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                     glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  if (shift) {
    rotate_scan(steps * kRotateStep);
    return true;
  }
  fitted_ = false;
  view_ = view_.zoomed(at, math::pow(kZoomStep, steps));
  return true;
}

bool ScenarioView::key(int key, int modifiers) {
  if (!scene_) return false;
  if ((modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return false;
  return view_key(key, modifiers) || edit_key(key) || layer_key(key) || tool_key(key);
}

bool ScenarioView::view_key(int key, int modifiers) {
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  const auto arrow = [&](double dx, double dy) {
    shift ? move_pointer(dx * kPointerStep, dy * kPointerStep)
          : pan(-dx * kPanStep, -dy * kPanStep);
  };
  return run_key(key, {{{GLFW_KEY_LEFT}, [&] { arrow(-1, 0); }},
                       {{GLFW_KEY_RIGHT}, [&] { arrow(1, 0); }},
                       {{GLFW_KEY_UP}, [&] { arrow(0, -1); }},
                       {{GLFW_KEY_DOWN}, [&] { arrow(0, 1); }},
                       {{GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD}, [&] { zoom(kZoomStep); }},
                       {{GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT}, [&] { zoom(1 / kZoomStep); }},
                       {{GLFW_KEY_0, GLFW_KEY_KP_0, GLFW_KEY_F}, [&] { fit(); }},
                       {{GLFW_KEY_L}, [&] { set_legend_open(!legend_open_); }},
                       {{GLFW_KEY_C},
                        [&] {
                          ResultsOverlay& overlay = studio_.results().overlay();
                          const int next = static_cast<int>(overlay.coloring()) + 1;
                          overlay.set_coloring(static_cast<RunColoring>(next % 3));
                        }},
                       {{GLFW_KEY_Q}, [&] { rotate_scan(kRotateStep); }},
                       {{GLFW_KEY_W}, [&] { rotate_scan(-kRotateStep); }},
                       {{GLFW_KEY_COMMA}, [&] { editor_.set_brush(editor_.brush() / kZoomStep); }},
                       {{GLFW_KEY_PERIOD}, [&] { editor_.set_brush(editor_.brush() * kZoomStep); }},
                       {{GLFW_KEY_T}, [&] { editor_.set_speed(editor_.speed() / kZoomStep); }},
                       {{GLFW_KEY_Y}, [&] { editor_.set_speed(editor_.speed() * kZoomStep); }}});
}

bool ScenarioView::edit_key(int key) {
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      if (editor_.can_finish())
        return end_edit([this] { return editor_.finish(scene_->scenario()); }), true;
      [[fallthrough]];
    case GLFW_KEY_SPACE:
      if (!pointer_) move_pointer(0, 0);
      editor_.pressed() ? release_tool() : press_tool();
      // One key press sets a corner; for other tools two key presses begin and end a drag.
      if ((tool() == EditTool::Polygon || tool() == EditTool::Mover ||
           tool() == EditTool::Person) &&
          editor_.pressed())
        release_tool();
      return true;
    case GLFW_KEY_ESCAPE:
      if (!editor_.busy() && tool() == EditTool::Look && error_.empty()) return false;
      editor_.busy() ? editor_.cancel() : editor_.set_tool(EditTool::Look);
      error_.clear();
      return true;
    default:
      return false;
  }
}

bool ScenarioView::layer_key(int key) {
  const int number = key - GLFW_KEY_1;
  if (number < 0 || number >= static_cast<int>(layers_.size())) return false;
  const SceneLayer& layer = layers_[static_cast<std::size_t>(number)];
  set_layer(layer.id, !layer.on);
  return true;
}

bool ScenarioView::tool_key(int key) {
  for (const EditToolInfo& info : edit_tools())
    if (mode_ == Mode::Edit && key == info.key) return set_tool(info.tool), true;
  return false;
}

/// Starts at the center of the canvas if there is no pointer; stays within the canvas.
void ScenarioView::move_pointer(double dx, double dy) {
  const ScreenRect& c = layout_.canvas;
  const Point from = pointer_ ? view_.to_screen(*pointer_) : c.center();
  const Point to(std::clamp(from.x + dx, c.left, c.left + c.width),
                 std::clamp(from.y + dy, c.top, c.top + c.height));
  pointer_moved(to);
  pointer_ = view_.to_world(to);
  keyboard_pointer_ = true;
  editor_.move(*pointer_);
}

}  // namespace slalom
