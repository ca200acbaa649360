#include "form_frame.h"

#include <slalom/gui/form_panel.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace slalom {

// How the panel of a form answers mouse and keyboard.

bool FormPanel::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return true;
  const ScreenRect at = {static_cast<double>(p.x() - mPos.x()),
                         static_cast<double>(p.y() - mPos.y()), 0, 0};
  if (at.top < form_frame::kTitleHeight) return false;  // the window is moved by its title
  // A button acts when it is let go: the screen remembers a widget that was pressed.
  const std::size_t stop = button_at(at);
  if (down) {
    pressed_ = stop;
    if (stop == 0) press(at, modifiers);
  } else if (const std::size_t pressed = std::exchange(pressed_, 0); stop != 0 && stop == pressed) {
    stop == ok_stop() ? accept() : cancel();
  }
  return true;
}

std::size_t FormPanel::button_at(const ScreenRect& at) const {
  if (ok_rect().contains(at.left, at.top)) return ok_stop();
  return !is_message() && cancel_rect().contains(at.left, at.top) ? cancel_stop() : 0;
}

void FormPanel::press(const ScreenRect& at, int modifiers) {
  if (!content().contains(at.left, at.top)) return;
  for (const FormLine& line : layout_.lines()) {
    const ScreenRect box = on_panel(line.box);
    if (!box.contains(at.left, at.top)) continue;
    press_line(line, at, modifiers);
    return;
  }
}

void FormPanel::press_line(const FormLine& line, const ScreenRect& at, int modifiers) {
  const std::size_t field = line.field;
  if (is_typed(field)) {
    if (focus_ == field) {
      editor_.move_to(letter_at(on_panel(line.box), at.left), (modifiers & GLFW_MOD_SHIFT) != 0);
    } else {
      go_to(field);
    }
    return;
  }
  if (focus_ != field) go_to(field);
  if (model_.fields()[field].kind == FieldKind::Flag) {
    choose(field, 0);
    return;
  }
  const std::vector<ScreenRect> choices = line.choices;  // choosing lays the form out anew
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (on_panel(choices[i]).contains(at.left, at.top)) {
      choose(field, i);
      return;
    }
}

bool FormPanel::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  const FormLine* line = is_typed(focus_) ? layout_.line_of(focus_) : nullptr;
  if (line == nullptr) return true;
  const double x = p.x() - mPos.x(), y = p.y() - mPos.y();
  const ScreenRect box = on_panel(line->box);
  if (box.contains(x, y)) editor_.move_to(letter_at(box, x), true);
  return true;
}

bool FormPanel::scrollEvent(const nanogui::Vector2i&, const nanogui::Vector2f& rel) {
  scroll_to(scroll_ - 40.0 * static_cast<double>(rel.y()));
  return true;
}

bool FormPanel::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE) return true;
  if (key == GLFW_KEY_ESCAPE) {
    cancel();
  } else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
    focus_ == cancel_stop() ? cancel() : accept();
  } else if (!move_focus(key, modifiers)) {
    is_typed(focus_) ? type(key, modifiers) : choose_by_key(key);
  }
  return true;
}

bool FormPanel::move_focus(int key, int modifiers) {
  const double page = content().height - 40;
  if (is_message() && (key == GLFW_KEY_UP || key == GLFW_KEY_DOWN)) {
    scroll_to(scroll_ + (key == GLFW_KEY_UP ? -40 : 40));
    return true;
  }
  switch (key) {
    case GLFW_KEY_TAB:
      go_on((modifiers & GLFW_MOD_SHIFT) != 0 ? -1 : 1);
      return true;
    case GLFW_KEY_DOWN:
      go_on(1);
      return true;
    case GLFW_KEY_UP:
      go_on(-1);
      return true;
    case GLFW_KEY_PAGE_DOWN:
      scroll_to(scroll_ + page);
      return true;
    case GLFW_KEY_PAGE_UP:
      scroll_to(scroll_ - page);
      return true;
    default:
      return false;
  }
}

bool FormPanel::type(int key, int modifiers) {
  const bool select = (modifiers & GLFW_MOD_SHIFT) != 0;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) return type_with_clipboard(key);
  switch (key) {
    case GLFW_KEY_LEFT:
      editor_.move(-1, select);
      return true;
    case GLFW_KEY_RIGHT:
      editor_.move(1, select);
      return true;
    case GLFW_KEY_HOME:
      editor_.move_to_begin(select);
      return true;
    case GLFW_KEY_END:
      editor_.move_to_end(select);
      return true;
    case GLFW_KEY_BACKSPACE:
      editor_.erase_before();
      break;
    case GLFW_KEY_DELETE:
      editor_.erase_behind();
      break;
    default:
      return false;
  }
  edited();
  return true;
}

bool FormPanel::type_with_clipboard(int key) {
  GLFWwindow* const window = screen()->glfwWindow();
  if (key == GLFW_KEY_A) {
    editor_.select_all();
    return true;
  }
  if ((key == GLFW_KEY_C || key == GLFW_KEY_X) && !editor_.selected().empty())
    glfwSetClipboardString(window, editor_.selected().c_str());
  if (key == GLFW_KEY_X && !editor_.selected().empty()) {
    editor_.erase_before();
    edited();
  }
  if (key == GLFW_KEY_V) {
    const char* const text = glfwGetClipboardString(window);
    if (text != nullptr) editor_.insert(text);
    edited();
  }
  return true;
}

bool FormPanel::choose_by_key(int key) {
  if (focus_ >= model_.fields().size()) {
    if (key == GLFW_KEY_SPACE) focus_ == ok_stop() ? accept() : cancel();
    if (!is_message() && (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT))
      focus_ = focus_ == ok_stop() ? cancel_stop() : ok_stop();
    return true;
  }
  const FormField& field = model_.fields()[focus_];
  const std::size_t count = std::max<std::size_t>(1, field.choices.size());
  if (key == GLFW_KEY_SPACE) {
    choose(focus_, choice_);
  } else if (key == GLFW_KEY_RIGHT || key == GLFW_KEY_LEFT) {
    choice_ = (choice_ + (key == GLFW_KEY_RIGHT ? 1 : count - 1)) % count;
    if (field.kind == FieldKind::Choice) choose(focus_, choice_);
  }
  return true;
}

bool FormPanel::keyboardCharacterEvent(unsigned int letter) {
  if (!is_typed(focus_)) return true;
  editor_.insert(utf8_of(letter));
  edited();
  return true;
}

}  // namespace slalom
