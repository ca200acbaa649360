#include "widgets/line_editor.h"

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
