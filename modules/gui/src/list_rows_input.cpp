#include "list_row_sizes.h"

#include <slalom/gui/list_rows.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kDoubleClick = 0.4;  // s
constexpr double kWheelStep = 56;     // pixels

}  // namespace

bool ListRows::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return false;
  if (!down) {
    grip_.reset();
    return true;
  }
  if (!focused()) requestFocus();
  const double x = p.x() - mPos.x(), y = p.y() - mPos.y();
  const auto shown = bar();
  if (shown && x >= shown->left) {
    if (shown->contains(x, y))
      grip_ = y - shown->top;
    else
      scroll_by(y < shown->top ? -height() : height());
  } else if (const auto line = line_below(p)) {
    press(*line, modifiers);
  }
  return true;
}

void ListRows::press(std::size_t line, int modifiers) {
  const ListLines::Line what = lines().at(line);
  if (what.group) {
    head_ = what.group;
    document_->toggle_group(*what.group);
    return;
  }
  const double now = glfwGetTime();
  const bool again = now - pressed_at_ < kDoubleClick && modifiers == 0 &&
                     document_->view().hashes[what.place] == document_->current();
  pressed_at_ = now;
  head_.reset();
  if ((modifiers & GLFW_MOD_SHIFT) != 0)
    document_->select_to(what.place);
  else if ((modifiers & GLFW_MOD_CONTROL) != 0)
    document_->toggle(what.place);
  else
    document_->select_only(what.place);
  if (again && on_show) on_show();
}

bool ListRows::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  const auto shown = bar();
  if (!grip_ || !shown) return false;
  const double room = std::max(height() - shown->height, 1.0);
  scroll_ = std::clamp((p.y() - mPos.y() - *grip_) / room, 0.0, 1.0) * most_scroll();
  return true;
}

bool ListRows::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  hovered_ = line_below(p);
  if (!hovered_) return true;
  const ListLines::Line what = lines().at(*hovered_);
  const ListRow* row = what.group ? nullptr : document_->row(document_->view().hashes[what.place]);
  const bool has_reason = row != nullptr && row->value && row->value->is_na();
  setTooltip(has_reason ? "NA: " + row->value->reason() : "");
  return true;
}

bool ListRows::mouseEnterEvent(const nanogui::Vector2i&, bool enter) {
  if (!enter) hovered_.reset();
  return true;
}

bool ListRows::scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) {
  scroll_by(-kWheelStep * rel.y());
  hovered_ = line_below(p);
  return true;
}

std::size_t ListRows::cursor_line() const {
  if (head_ && *head_ < document_->view().groups.size()) return lines().line_of_group(*head_);
  const auto place = document_->view().place_of(document_->current());
  if (!place) return 0;
  if (const auto line = lines().line_of(*place)) return *line;
  return lines().line_of_group(lines().group_of(*place).value_or(0));
}

void ListRows::go_to_line(std::size_t line, int modifiers) {
  const ListLines::Line what = lines().at(line);
  bring_into_view(line);
  head_ = what.group;
  if (what.group) return;
  if ((modifiers & GLFW_MOD_SHIFT) != 0)
    document_->select_to(what.place);
  else if ((modifiers & GLFW_MOD_CONTROL) != 0)
    document_->set_current(document_->view().hashes[what.place]);
  else
    document_->select_only(what.place);
  followed_ = document_->current();
}

bool ListRows::fold(bool closed) {
  const auto place = document_->view().place_of(document_->current());
  const auto group = head_ ? head_ : place ? lines().group_of(*place) : std::nullopt;
  if (!group || *group >= document_->view().groups.size()) return false;
  if (lines().is_closed(*group) != closed) document_->toggle_group(*group);
  if (closed) head_ = group;
  return true;
}

bool ListRows::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || document_ == nullptr || lines().size() == 0) return false;
  if ((modifiers & GLFW_MOD_ALT) != 0) return false;
  if (head_ && *head_ >= document_->view().groups.size()) head_.reset();
  const std::size_t at = cursor_line(), last = lines().size() - 1;
  const auto page = static_cast<std::size_t>(std::max(height() / kLineHeights.scenario - 1, 1.0));
  const auto place = document_->view().place_of(document_->current());
  switch (key) {
    case GLFW_KEY_UP:
      go_to_line(at > 0 ? at - 1 : 0, modifiers);
      return true;
    case GLFW_KEY_DOWN:
      go_to_line(std::min(at + 1, last), modifiers);
      return true;
    case GLFW_KEY_PAGE_UP:
      go_to_line(at > page ? at - page : 0, modifiers);
      return true;
    case GLFW_KEY_PAGE_DOWN:
      go_to_line(std::min(at + page, last), modifiers);
      return true;
    case GLFW_KEY_HOME:
      go_to_line(0, modifiers);
      return true;
    case GLFW_KEY_END:
      go_to_line(last, modifiers);
      return true;
    case GLFW_KEY_LEFT:
    case GLFW_KEY_RIGHT:
      return fold(key == GLFW_KEY_LEFT);
    case GLFW_KEY_SPACE:
      if (head_)
        document_->toggle_group(*head_);
      else if (place)
        document_->toggle(*place);
      return true;
    case GLFW_KEY_A:
      if ((modifiers & GLFW_MOD_CONTROL) == 0) return false;
      document_->select_all();
      return true;
    case GLFW_KEY_ESCAPE:
      if (document_->selected_count() == 0) return false;
      document_->select_none();
      return true;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      if (on_show) on_show();
      return true;
    default:
      return false;
  }
}

}  // namespace slalom
