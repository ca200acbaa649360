// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/element.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <nanovg.h>

namespace slalom {

ScreenRect Element::area() const {
  return {0, 0, static_cast<double>(width()), static_cast<double>(height())};
}

void Element::set_bounds(const ScreenRect& rect) {
  setPosition({static_cast<int>(rect.left), static_cast<int>(rect.top)});
  setSize({std::max(static_cast<int>(rect.width), 0), std::max(static_cast<int>(rect.height), 0)});
}

std::optional<ScreenRect> Element::rect_of(const std::string& part) const {
  if (part.empty()) return area();
  for (const Part& own : parts())
    if (own.name == part) return own.rect;
  for (const Widget* child : children()) {
    const auto* element = dynamic_cast<const Element*>(child);
    auto rect = element && element->visible() ? element->rect_of(part) : std::nullopt;
    if (!rect) continue;
    rect->left += child->position().x();
    rect->top += child->position().y();
    return rect;
  }
  return std::nullopt;
}

std::string Element::part_at(const Point& at) const {
  for (const Part& part : parts())
    if (part.rect.contains(at)) return part.name;
  return "";
}

bool Element::press(const Point& at, int /*modifiers*/) {
  click(part_at(at));
  return true;
}

bool Element::run_key(int key, const std::vector<KeyAction>& actions) {
  for (const KeyAction& action : actions)
    if (std::find(action.keys.begin(), action.keys.end(), key) != action.keys.end())
      return action.run(), true;
  return false;
}

Element::Point Element::local(const nanogui::Vector2i& p) const {
  return {static_cast<double>(p.x() - mPos.x()), static_cast<double>(p.y() - mPos.y())};
}

void Element::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  paint(ctx);
  nvgRestore(ctx);
  Widget::draw(ctx);
}

bool Element::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) {
  if (down && focus_ == Focus::OnPress && !focused()) requestFocus();
  const nanogui::Vector2i inside = p - mPos;
  for (auto child = mChildren.rbegin(); child != mChildren.rend(); ++child)
    if ((*child)->visible() && (*child)->contains(inside) &&
        (*child)->mouseButtonEvent(inside, button, down, modifiers))
      return true;
  if (button == GLFW_MOUSE_BUTTON_RIGHT && down) press_right(local(p));
  if (button != GLFW_MOUSE_BUTTON_LEFT) return true;
  if (down) return press(local(p), modifiers);
  release(local(p));
  return true;
}

bool Element::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                               int modifiers) {
  hover(contains(p) ? std::optional(local(p)) : std::nullopt);
  Widget::mouseMotionEvent(p, rel, button, modifiers);
  return true;
}

bool Element::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                             int /*button*/, int /*modifiers*/) {
  drag(local(p));
  return true;
}

bool Element::mouseEnterEvent(const nanogui::Vector2i& p, bool enter) {
  if (!enter) hover(std::nullopt);
  return Widget::mouseEnterEvent(p, enter);
}

bool Element::scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) {
  // Some systems scroll horizontally while shift is held.
  const double steps = static_cast<double>(rel.y() != 0 ? rel.y() : rel.x());
  return Widget::scrollEvent(p, rel) || wheel(local(p), steps);
}

bool Element::keyboardEvent(int key, int /*scancode*/, int action, int modifiers) {
  return action != GLFW_RELEASE && this->key(key, modifiers);
}

}  // namespace slalom
