#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/results_overlay.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The runs of an overlay, a line each: a box that shows or hides it, the colour of its method, how
/// it ended in colour and word, its length and time. Keys when it has the focus: Up, Down, Home,
/// End, Space (show or hide), A (all or none).
///
/// Parts: "all" (the box of all runs), "row 0", "row 1", ..., or by the label: "row nd 3".
class RunTable : public Element {
 public:
  RunTable(nanogui::Widget* parent, ResultsOverlay& overlay);

  std::function<void()> on_changed;  ///< what is shown has changed

  void set_message(std::string message);  ///< in place of lines where there are none
  const std::string& message() const { return message_; }
  void refresh();  ///< the overlay has other runs
  std::size_t cursor() const { return cursor_; }
  void move_cursor(int steps);
  void toggle_cursor();
  void toggle_all();  ///< hides all if any is shown

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  static constexpr double kRowHeight = 24, kHeaderHeight = 24, kDetailHeight = 40, kMargin = 6;
  static constexpr double kBox = 14, kScrollBar = 6;  ///< pixels
  /// Left edges; a column that has no place has the width 0.
  struct Columns {
    double label = 0, label_width = 0, outcome = 0, outcome_width = 0;
    double success = 0, success_width = 0, length = 0, time = 0, number_width = 66;
  };
  Columns columns() const;
  static std::string shown_value(const Value& value);
  std::size_t visible_rows() const;
  void scroll_to(std::ptrdiff_t first);
  void keep_cursor_visible();
  bool any_shown() const;
  bool has_keyboard() const;
  ScreenRect box_of_all() const;
  ScreenRect row_rect(std::size_t row) const;  ///< of a visible one
  std::optional<std::size_t> row_at(const nanogui::Vector2i& p) const;
  void changed();
  void draw_header(NVGcontext* ctx) const;
  void draw_row(NVGcontext* ctx, std::size_t row) const;
  void draw_detail(NVGcontext* ctx) const;
  void draw_scroll_bar(NVGcontext* ctx) const;

  ResultsOverlay& overlay_;
  std::vector<OverlayRow> rows_;
  std::string message_;
  std::size_t first_ = 0, cursor_ = 0;
  std::optional<std::size_t> hovered_;
};

}  // namespace slalom
