#include "utf8.h"

#include <slalom/gui/line_editor.h>

#include <algorithm>

namespace slalom {
namespace {

std::string without_control(const std::string& text) {
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
  text_ = without_control(text);
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
  const std::string typed = without_control(text);
  if (text_.size() + typed.size() > kLongest) return;
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

void LineEditor::erase_before() {
  if (!erase_selection()) {
    anchor_ = before(cursor_);
    erase_selection();
  }
}

void LineEditor::erase_behind() {
  if (!erase_selection()) {
    anchor_ = behind(cursor_);
    erase_selection();
  }
}

void LineEditor::move(int letters, bool select) {
  std::size_t place = cursor_;
  if (!select && cursor_ != anchor_) {
    place = letters < 0 ? selection_begin() : selection_end();
    letters -= letters < 0 ? -1 : 1;
  }
  for (; letters < 0; ++letters) place = before(place);
  for (; letters > 0; --letters) place = behind(place);
  move_to(place, select);
}

void LineEditor::move_to(std::size_t place, bool select) {
  cursor_ = std::min(place, text_.size());
  while (cursor_ > 0 && cursor_ < text_.size() && continues_letter(text_[cursor_])) --cursor_;
  if (!select) anchor_ = cursor_;
}

void LineEditor::select_all() {
  anchor_ = 0;
  cursor_ = text_.size();
}

std::size_t LineEditor::before(std::size_t place) const {
  if (place == 0) return 0;
  --place;
  while (place > 0 && continues_letter(text_[place])) --place;
  return place;
}

std::size_t LineEditor::behind(std::size_t place) const {
  if (place >= text_.size()) return text_.size();
  ++place;
  while (place < text_.size() && continues_letter(text_[place])) ++place;
  return place;
}

std::string utf8_of(unsigned int letter) {
  const auto byte = [](unsigned int value) { return static_cast<char>(value); };
  if (letter < 0x20 || (letter >= 0x7F && letter < 0xA0) || letter > 0x10FFFF ||
      (letter >= 0xD800 && letter < 0xE000))
    return "";
  if (letter < 0x80) return {byte(letter)};
  if (letter < 0x800) return {byte(0xC0 | (letter >> 6)), byte(0x80 | (letter & 0x3F))};
  if (letter < 0x10000)
    return {byte(0xE0 | (letter >> 12)), byte(0x80 | ((letter >> 6) & 0x3F)),
            byte(0x80 | (letter & 0x3F))};
  return {byte(0xF0 | (letter >> 18)), byte(0x80 | ((letter >> 12) & 0x3F)),
          byte(0x80 | ((letter >> 6) & 0x3F)), byte(0x80 | (letter & 0x3F))};
}

}  // namespace slalom
