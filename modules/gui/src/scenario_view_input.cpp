#include <slalom/core/error.h>
#include <slalom/gui/scenario_view.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kTurnStep = 5 * 3.14159265358979323846 / 180;  ///< rad
constexpr double kPanStep = 40;                                 ///< pixels
constexpr double kPointerStep = 10;                             ///< pixels
constexpr double kTolerance = 6;                                ///< pixels

}  // namespace

ScenarioView::Point ScenarioView::local(const nanogui::Vector2i& p) const {
  return {static_cast<double>(p.x() - position().x()), static_cast<double>(p.y() - position().y())};
}

bool ScenarioView::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                    int modifiers) {
  const Point at = local(p);
  if (!down) {
    panning_ = false;
    scan_pin_.reset();
    if (button == GLFW_MOUSE_BUTTON_LEFT) release();
    return true;
  }
  requestFocus();
  adjust_to_size();
  moved_to(at, {0, 0}, 0);
  if (const ViewLayout::Part* part = layout_.at(at.x, at.y)) {
    if (button == GLFW_MOUSE_BUTTON_LEFT) choose_part(part->name);
    return true;
  }
  if (!scene_ || !layout_.canvas().contains(at.x, at.y)) return true;
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  if (button == GLFW_MOUSE_BUTTON_LEFT && shift && layer_on("scan"))
    scan_pin_ = pointer_;
  else if (button != GLFW_MOUSE_BUTTON_LEFT || tool() == EditTool::Look)
    panning_ = true;
  else
    press();
  return true;
}

bool ScenarioView::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel,
                                    int button, int) {
  moved_to(local(p), {static_cast<double>(rel.x()), static_cast<double>(rel.y())}, button);
  return true;
}

bool ScenarioView::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel,
                                  int button, int) {
  moved_to(local(p), {static_cast<double>(rel.x()), static_cast<double>(rel.y())}, button);
  return true;
}

bool ScenarioView::mouseEnterEvent(const nanogui::Vector2i& p, bool enter) {
  if (!enter) hovered_.clear();
  if (!enter && !editor_.busy() && !keyboard_pointer_) pointer_.reset();
  return Widget::mouseEnterEvent(p, enter);
}

/// `by` (pixels) moves the view while it is dragged with one of the `buttons` (a mask).
void ScenarioView::moved_to(const Point& at, const Point& by, int buttons) {
  const ViewLayout::Part* part = layout_.at(at.x, at.y);
  hovered_ = part != nullptr ? part->name : "";
  if (panning_ && buttons != 0) pan(by.x, by.y);
  if (!scene_) return;
  const bool busy = panning_ || scan_pin_ || editor_.busy();
  if (!busy && (part != nullptr || !layout_.canvas().contains(at.x, at.y))) {
    if (!keyboard_pointer_) pointer_.reset();
    return;
  }
  keyboard_pointer_ = false;
  pointer_ = view_.to_world(at);
  if (scan_pin_ && std::hypot(pointer_->x - scan_pin_->x, pointer_->y - scan_pin_->y) *
                           view_.pixels_per_metre() >
                       kTolerance)
    heading_ = std::atan2(pointer_->y - scan_pin_->y, pointer_->x - scan_pin_->x);
  editor_.move(*pointer_);
}

/// By value: what is chosen may lay the parts out anew, and a part's name would go with it.
void ScenarioView::choose_part(const std::string name) {
  if (name == "legend") set_legend_open(!legend_open_);
  if (name == "zoom in") zoom(kZoomStep);
  if (name == "zoom out") zoom(1 / kZoomStep);
  if (name == "fit") fit();
  for (const EditToolInfo& info : edit_tools())
    if (name == "tool " + info.id) set_tool(info.tool);
  for (const auto& layer : layers_)
    if (name == "layer " + layer->id()) return set_layer(layer->id(), !layer->on());
}

void ScenarioView::press() {
  refusal_.clear();
  if (scene_ && pointer_)
    editor_.press(scene_->scenario(), *pointer_, kTolerance / view_.pixels_per_metre());
}

void ScenarioView::release() {
  if (!scene_ || !pointer_) return editor_.cancel();
  end_edit([this] { return editor_.release(scene_->scenario(), *pointer_); });
}

/// Hands the edit over, or says why it cannot be.
template <typename End>
void ScenarioView::end_edit(End end) {
  try {
    const std::optional<SceneEdit> edit = end();
    if (edit && on_edit) on_edit(*edit);
  } catch (const Error& e) {
    refusal_ = e.what();
  }
}

bool ScenarioView::scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) {
  const Point at = local(p);
  if (!scene_ || !layout_.canvas().contains(at.x, at.y)) return true;
  // A turn of the wheel comes without modifiers.
  GLFWwindow* window = screen()->glfwWindow();
  const bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                     glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  // Some systems turn the wheel sideways while shift is held.
  const double steps = rel.y() != 0 ? rel.y() : rel.x();
  if (shift) {
    turn_scan(steps * kTurnStep);
    return true;
  }
  fitted_ = false;
  view_ = view_.zoomed(at, std::pow(kZoomStep, steps));
  return true;
}

bool ScenarioView::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || !scene_) return false;
  if ((modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return false;
  return view_key(key, modifiers) || edit_key(key) || layer_key(key) || tool_key(key);
}

bool ScenarioView::view_key(int key, int modifiers) {
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  const auto arrow = [&](double dx, double dy) {
    shift ? move_pointer(dx * kPointerStep, dy * kPointerStep)
          : pan(-dx * kPanStep, -dy * kPanStep);
    return true;
  };
  switch (key) {
    case GLFW_KEY_LEFT:
      return arrow(-1, 0);
    case GLFW_KEY_RIGHT:
      return arrow(1, 0);
    case GLFW_KEY_UP:
      return arrow(0, -1);
    case GLFW_KEY_DOWN:
      return arrow(0, 1);
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return zoom(kZoomStep), true;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return zoom(1 / kZoomStep), true;
    case GLFW_KEY_0:
    case GLFW_KEY_KP_0:
    case GLFW_KEY_F:
      return fit(), true;
    case GLFW_KEY_L:
      return set_legend_open(!legend_open_), true;
    case GLFW_KEY_Q:
      return turn_scan(kTurnStep), true;
    case GLFW_KEY_W:
      return turn_scan(-kTurnStep), true;
    default:
      return false;
  }
}

bool ScenarioView::edit_key(int key) {
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      if (tool() == EditTool::Polygon &&
          editor_.preview(scene_->scenario()).open_polygon.size() > 3)
        return end_edit([this] { return editor_.finish(scene_->scenario()); }), true;
      [[fallthrough]];
    case GLFW_KEY_SPACE:
      if (!pointer_) move_pointer(0, 0);
      editor_.pressed() ? release() : press();
      // Corners are set by one key; for the others the way between two keys is the drag.
      if (tool() == EditTool::Polygon && editor_.pressed()) release();
      return true;
    case GLFW_KEY_COMMA:
      return editor_.set_brush(editor_.brush() / kZoomStep), true;
    case GLFW_KEY_PERIOD:
      return editor_.set_brush(editor_.brush() * kZoomStep), true;
    case GLFW_KEY_ESCAPE:
      if (!editor_.busy() && tool() == EditTool::Look && refusal_.empty()) return false;
      editor_.busy() ? editor_.cancel() : editor_.set_tool(EditTool::Look);
      refusal_.clear();
      return true;
    default:
      return false;
  }
}

bool ScenarioView::layer_key(int key) {
  const int number = key - GLFW_KEY_1;
  if (number < 0 || number >= static_cast<int>(layers_.size())) return false;
  const SceneLayer& layer = *layers_[static_cast<std::size_t>(number)];
  set_layer(layer.id(), !layer.on());
  return true;
}

bool ScenarioView::tool_key(int key) {
  for (const EditToolInfo& info : edit_tools())
    if (on_edit && key == info.key) return set_tool(info.tool), true;
  return false;
}

/// From the middle of what is seen, if it is nowhere yet; never out of sight.
void ScenarioView::move_pointer(double dx, double dy) {
  const ScreenRect& c = layout_.canvas();
  const Point from =
      pointer_ ? view_.to_screen(*pointer_) : Point(c.left + 0.5 * c.width, c.top + 0.5 * c.height);
  const Point to(std::clamp(from.x + dx, c.left, c.left + c.width),
                 std::clamp(from.y + dy, c.top, c.top + c.height));
  moved_to(to, {0, 0}, 0);
  pointer_ = view_.to_world(to);
  keyboard_pointer_ = true;
  editor_.move(*pointer_);
}

}  // namespace slalom
