// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <cstddef>
#include <string>

namespace slalom {

/// An editable line of UTF-8 text with a cursor and a selection. Positions are byte offsets, always
/// at the beginning of a character or at the end of the text.
class LineEditor {
 public:
  explicit LineEditor(const std::string& text = "");

  const std::string& text() const { return text_; }
  void set_text(const std::string& text);  ///< moves the cursor to the end
  std::size_t cursor() const { return cursor_; }
  std::size_t selection_begin() const;
  std::size_t selection_end() const;
  std::string selected() const;

  /// Replaces the selection; removes control characters such as line breaks. Inserts nothing if the
  /// text would be longer than kMaxLength bytes.
  void insert(const std::string& text);
  void erase_backward();                   ///< the selection, or the character before the cursor
  void erase_forward();                    ///< the selection, or the character after the cursor
  void move(int characters, bool select);  ///< backwards if negative
  void move_to(std::size_t position, bool select);
  void move_to_begin(bool select) { move_to(0, select); }
  void move_to_end(bool select) { move_to(text_.size(), select); }
  void select_all();

  /// Handles a key of a text field in the window of `owner`. Returns whether it is one that edits.
  bool key(int key, int modifiers, nanogui::Widget& owner);
  /// Moves the cursor to the character at `x` (pixels) of the text in `box`.
  void click(NVGcontext* ctx, const ScreenRect& box, double x, bool select);
  void draw(NVGcontext* ctx, const ScreenRect& box) const;

  static constexpr std::size_t kMaxLength = 4096;
  static constexpr double kInset = 6;  ///< of the text in its box, pixels

 private:
  double offset(NVGcontext* ctx, const ScreenRect& box) const;
  bool erase_selection();
  std::size_t previous(std::size_t position) const;
  std::size_t next(std::size_t position) const;

  std::string text_;
  std::size_t cursor_ = 0, anchor_ = 0;
};

/// Encodes a Unicode code point as UTF-8; empty for control characters and invalid code points.
std::string utf8_of(unsigned int code_point);

}  // namespace slalom
