#pragma once

#include <cstddef>
#include <string>

namespace slalom {

/// One line of text (UTF-8) that is being typed, with a cursor and a selection. Places are bytes,
/// always at the beginning of a letter or at the end.
class LineEditor {
 public:
  explicit LineEditor(const std::string& text = "");

  const std::string& text() const { return text_; }
  void set_text(const std::string& text);  ///< the cursor behind it
  std::size_t cursor() const { return cursor_; }
  std::size_t selection_begin() const;
  std::size_t selection_end() const;
  std::string selected() const;

  /// In place of the selection; without line breaks and other control characters. Nothing beyond
  /// kLongest bytes.
  void insert(const std::string& text);
  void erase_before();  ///< the selection, or the letter before the cursor
  void erase_behind();
  void move(int letters, bool select);  ///< backwards below 0
  void move_to(std::size_t place, bool select);
  void move_to_begin(bool select) { move_to(0, select); }
  void move_to_end(bool select) { move_to(text_.size(), select); }
  void select_all();

  static constexpr std::size_t kLongest = 4096;

 private:
  bool erase_selection();
  std::size_t before(std::size_t place) const;
  std::size_t behind(std::size_t place) const;

  std::string text_;
  std::size_t cursor_ = 0, anchor_ = 0;
};

/// A letter by its number in Unicode as UTF-8; empty for control characters and what is no letter.
std::string utf8_of(unsigned int letter);

}  // namespace slalom
