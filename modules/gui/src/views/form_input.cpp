#include "views/form_panel.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace slalom {

// Mouse and keyboard input of a form panel.

bool FormPanel::press(const Point& at, int modifiers) {
  if (at.y < form_metrics::kTitleHeight) return false;  // dragging the title moves the dialog
  pressed_ = button_at(at);
  if (pressed_ != 0 || scroll_.press(at) || !content().contains(at)) return true;
  for (const FormLine& line : layout_.lines())
    if (to_panel(line.box).contains(at)) {
      press_line(line, at, modifiers);
      break;
    }
  return true;
}

/// A button acts on release: the screen keeps a pointer to the widget that was pressed.
void FormPanel::release(const Point& at) {
  scroll_.release();
  const std::size_t stop = button_at(at), pressed = std::exchange(pressed_, 0);
  if (stop != 0 && stop == pressed) stop == ok_tab_stop() ? accept() : cancel();
}

std::size_t FormPanel::button_at(const Point& at) const {
  if (ok_rect().contains(at)) return ok_tab_stop();
  return !is_message() && cancel_rect().contains(at) ? cancel_tab_stop() : 0;
}

void FormPanel::press_line(const FormLine& line, const Point& at, int modifiers) {
  const std::size_t field = line.field;
  if (is_text_field(field)) {
    if (focus_ == field) {
      editor_.move_to(character_at(to_panel(line.box), at.x), (modifiers & GLFW_MOD_SHIFT) != 0);
    } else {
      set_focus_to(field);
    }
    return;
  }
  if (focus_ != field) set_focus_to(field);
  if (model_.fields()[field].kind == FieldKind::Flag) {
    choose(field, 0);
    return;
  }
  const std::vector<ScreenRect> choices = line.choices;  // a copy: choosing changes the layout
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (to_panel(choices[i]).contains(at)) {
      choose(field, i);
      return;
    }
}

void FormPanel::drag(const Point& at) {
  const FormLine* line = is_text_field(focus_) ? layout_.line_of(focus_) : nullptr;
  if (scroll_.drag(at) || line == nullptr) return;
  const ScreenRect box = to_panel(line->box);
  if (box.contains(at)) editor_.move_to(character_at(box, at.x), true);
}

bool FormPanel::wheel(const Point& /*at*/, double steps) {
  scroll_.wheel(steps);
  return true;
}

bool FormPanel::key(int key, int modifiers) {
  if (key == GLFW_KEY_ESCAPE) {
    cancel();
  } else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
    focus_ == cancel_tab_stop() ? cancel() : accept();
  } else if (!move_focus(key, modifiers)) {
    is_text_field(focus_) ? handle_text_key(key, modifiers) : choose_by_key(key);
  }
  return true;
}

bool FormPanel::move_focus(int key, int modifiers) {
  const double page = content().height - 40;
  if (is_message() && (key == GLFW_KEY_UP || key == GLFW_KEY_DOWN)) {
    scroll_.by(key == GLFW_KEY_UP ? -40 : 40);
    return true;
  }
  switch (key) {
    case GLFW_KEY_TAB:
      move_focus_by((modifiers & GLFW_MOD_SHIFT) != 0 ? -1 : 1);
      return true;
    case GLFW_KEY_DOWN:
      move_focus_by(1);
      return true;
    case GLFW_KEY_UP:
      move_focus_by(-1);
      return true;
    case GLFW_KEY_PAGE_DOWN:
      scroll_.by(page);
      return true;
    case GLFW_KEY_PAGE_UP:
      scroll_.by(-page);
      return true;
    default:
      return false;
  }
}

void FormPanel::handle_text_key(int key, int modifiers) {
  const bool select = (modifiers & GLFW_MOD_SHIFT) != 0;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) return handle_control_key(key);
  if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT)
    editor_.move(key == GLFW_KEY_LEFT ? -1 : 1, select);
  if (key == GLFW_KEY_HOME) editor_.move_to_begin(select);
  if (key == GLFW_KEY_END) editor_.move_to_end(select);
  if (key == GLFW_KEY_BACKSPACE) editor_.erase_backward();
  if (key == GLFW_KEY_DELETE) editor_.erase_forward();
  if (key == GLFW_KEY_BACKSPACE || key == GLFW_KEY_DELETE) edited();
}

void FormPanel::handle_control_key(int key) {
  GLFWwindow* const window = screen()->glfwWindow();
  if (key == GLFW_KEY_A) editor_.select_all();
  if ((key == GLFW_KEY_C || key == GLFW_KEY_X) && !editor_.selected().empty())
    glfwSetClipboardString(window, editor_.selected().c_str());
  if (key == GLFW_KEY_X && !editor_.selected().empty()) {
    editor_.erase_backward();
    edited();
  }
  if (key == GLFW_KEY_V) {
    const char* const text = glfwGetClipboardString(window);
    if (text != nullptr) editor_.insert(text);
    edited();
  }
}

void FormPanel::choose_by_key(int key) {
  if (focus_ >= model_.fields().size()) {
    if (key == GLFW_KEY_SPACE) focus_ == ok_tab_stop() ? accept() : cancel();
    if (!is_message() && (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT))
      focus_ = focus_ == ok_tab_stop() ? cancel_tab_stop() : ok_tab_stop();
    return;
  }
  const FormField& field = model_.fields()[focus_];
  const std::size_t count = std::max<std::size_t>(1, field.choices.size());
  if (key == GLFW_KEY_SPACE) {
    choose(focus_, choice_);
  } else if (key == GLFW_KEY_RIGHT || key == GLFW_KEY_LEFT) {
    choice_ = (choice_ + (key == GLFW_KEY_RIGHT ? 1 : count - 1)) % count;
    if (field.kind == FieldKind::Choice) choose(focus_, choice_);
  }
}

bool FormPanel::keyboardCharacterEvent(unsigned int code_point) {
  if (!is_text_field(focus_)) return true;
  editor_.insert(utf8_of(code_point));
  edited();
  return true;
}

}  // namespace slalom
