// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drawing.h"
#include "widgets/line_editor.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

std::string without_control_characters(const std::string& text) {
  std::string kept;
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0x20U && c != 0x7F) kept += c;
  return kept;
}

}  // namespace

LineEditor::LineEditor(const std::string& text) {
  set_text(text);
}

void LineEditor::set_text(const std::string& text) {
  text_ = without_control_characters(text);
  cursor_ = anchor_ = text_.size();
}

std::size_t LineEditor::selection_begin() const {
  return std::min(cursor_, anchor_);
}
std::size_t LineEditor::selection_end() const {
  return std::max(cursor_, anchor_);
}
std::string LineEditor::selected() const {
  return text_.substr(selection_begin(), selection_end() - selection_begin());
}

void LineEditor::insert(const std::string& text) {
  erase_selection();
  const std::string typed = without_control_characters(text);
  if (text_.size() + typed.size() > kMaxLength) return;
  text_.insert(cursor_, typed);
  cursor_ = anchor_ = cursor_ + typed.size();
}

bool LineEditor::erase_selection() {
  if (cursor_ == anchor_) return false;
  const std::size_t begin = selection_begin();
  text_.erase(begin, selection_end() - begin);
  cursor_ = anchor_ = begin;
  return true;
}

void LineEditor::erase_backward() {
  if (!erase_selection()) {
    anchor_ = previous(cursor_);
    erase_selection();
  }
}

void LineEditor::erase_forward() {
  if (!erase_selection()) {
    anchor_ = next(cursor_);
    erase_selection();
  }
}

void LineEditor::move(int characters, bool select) {
  std::size_t position = cursor_;
  if (!select && cursor_ != anchor_) {
    position = characters < 0 ? selection_begin() : selection_end();
    characters -= characters < 0 ? -1 : 1;
  }
  for (; characters < 0; ++characters) position = previous(position);
  for (; characters > 0; --characters) position = next(position);
  move_to(position, select);
}

void LineEditor::move_to(std::size_t position, bool select) {
  cursor_ = std::min(position, text_.size());
  while (cursor_ > 0 && cursor_ < text_.size() && is_continuation_byte(text_[cursor_])) --cursor_;
  if (!select) anchor_ = cursor_;
}

void LineEditor::select_all() {
  anchor_ = 0;
  cursor_ = text_.size();
}

std::size_t LineEditor::previous(std::size_t position) const {
  if (position == 0) return 0;
  --position;
  while (position > 0 && is_continuation_byte(text_[position])) --position;
  return position;
}

std::size_t LineEditor::next(std::size_t position) const {
  if (position >= text_.size()) return text_.size();
  ++position;
  while (position < text_.size() && is_continuation_byte(text_[position])) ++position;
  return position;
}

bool LineEditor::key(int key, int modifiers, nanogui::Widget& owner) {
  const bool select = (modifiers & GLFW_MOD_SHIFT) != 0;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) {
    GLFWwindow* const window = owner.screen()->glfwWindow();
    const bool cuts = key == GLFW_KEY_X && cursor_ != anchor_;
    if (key == GLFW_KEY_A) select_all();
    if (cuts || (key == GLFW_KEY_C && cursor_ != anchor_))
      glfwSetClipboardString(window, selected().c_str());
    if (cuts) erase_selection();
    const char* const copied = key == GLFW_KEY_V ? glfwGetClipboardString(window) : nullptr;
    if (copied != nullptr) insert(copied);
    return cuts || copied != nullptr;
  }
  if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT) move(key == GLFW_KEY_LEFT ? -1 : 1, select);
  if (key == GLFW_KEY_HOME) move_to_begin(select);
  if (key == GLFW_KEY_END) move_to_end(select);
  if (key == GLFW_KEY_BACKSPACE) erase_backward();
  if (key == GLFW_KEY_DELETE) erase_forward();
  return key == GLFW_KEY_BACKSPACE || key == GLFW_KEY_DELETE;
}

/// The text scrolls so that the cursor is visible.
double LineEditor::offset(NVGcontext* ctx, const ScreenRect& box) const {
  return std::max(0.0,
                  draw::text_width(ctx, text_.substr(0, cursor_)) - box.width + 2 * kInset + 2);
}

void LineEditor::click(NVGcontext* ctx, const ScreenRect& box, double x, bool select) {
  const double target = x - box.left - kInset + offset(ctx, box);
  std::size_t position = 0;
  for (double left = 0; position < text_.size(); position = next(position)) {
    const double right = draw::text_width(ctx, text_.substr(0, next(position)));
    if (target < 0.5 * (left + right)) break;
    left = right;
  }
  move_to(position, select);
}

void LineEditor::draw(NVGcontext* ctx, const ScreenRect& box) const {
  const auto x_of = [&](std::size_t position) {
    return box.left + kInset + draw::text_width(ctx, text_.substr(0, position)) - offset(ctx, box);
  };
  nvgSave(ctx);
  draw::clip(ctx, box.inset(2));
  const double begin = x_of(selection_begin()), end = x_of(selection_end());
  if (end > begin)
    draw::fill(ctx, {begin, box.top + 3, end - begin, box.height - 6}, palette().selected);
  draw::text(ctx, {x_of(0), box.top, draw::text_width(ctx, text_) + 2, box.height}, text_,
             palette().text);
  const double cursor = x_of(cursor_);
  draw::line(ctx, cursor, box.top + 4, cursor, box.bottom() - 4, palette().accent, 1.5F);
  nvgRestore(ctx);
}

std::string utf8_of(unsigned int code_point) {
  const auto byte = [](unsigned int value) { return static_cast<char>(value); };
  if (code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0) || code_point > 0x10FFFF ||
      (code_point >= 0xD800 && code_point < 0xE000))
    return "";
  if (code_point < 0x80) return {byte(code_point)};
  if (code_point < 0x800) return {byte(0xC0 | (code_point >> 6)), byte(0x80 | (code_point & 0x3F))};
  if (code_point < 0x10000)
    return {byte(0xE0 | (code_point >> 12)), byte(0x80 | ((code_point >> 6) & 0x3F)),
            byte(0x80 | (code_point & 0x3F))};
  return {byte(0xF0 | (code_point >> 18)), byte(0x80 | ((code_point >> 12) & 0x3F)),
          byte(0x80 | ((code_point >> 6) & 0x3F)), byte(0x80 | (code_point & 0x3F))};
}

}  // namespace slalom
