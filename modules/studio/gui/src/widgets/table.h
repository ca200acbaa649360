// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <cstddef>

namespace slalom {

/// Vertical scrolling of a content in a view, with a bar at the right edge that can be dragged.
class Scroll {
 public:
  static constexpr double kBarWidth = 10;  ///< pixels

  /// Sets the height (pixels) of the content and the rectangle of the view in its element.
  void set(double content_height, const ScreenRect& view);
  double offset() const { return offset_; }  ///< of the upper edge of the view in the content
  double max_offset() const;
  void to(double offset);  ///< clamped
  void by(double pixels) { to(offset_ + pixels); }
  void wheel(double steps) { by(-kWheelStep * steps); }
  void show(double top, double bottom);  ///< brings this part of the content into view

  std::optional<ScreenRect> thumb() const;  ///< none if everything is in view
  void draw(NVGcontext* ctx) const;
  bool press(const Element::Point& at);  ///< returns whether it is on the bar
  bool drag(const Element::Point& at);   ///< returns whether the bar is dragged
  void release() { grip_.reset(); }

 private:
  static constexpr double kWheelStep = 56;  ///< pixels
  double offset_ = 0, content_ = 0;
  ScreenRect view_;
  std::optional<double> grip_;  ///< from the top of the thumb to the mouse while it is dragged
};

/// Rows that scroll between a header and a footer; one of them has the cursor. Draws only the
/// visible rows. Keys: Up, Down, Page Up, Page Down, Home, End. Part "bar": the scroll bar.
class Table : public Element {
 public:
  struct Heights {
    double header, row, footer;  ///< pixels
  };
  Table(nanogui::Widget* parent, const std::string& id, const Heights& heights,
        Focus focus = Focus::None)
      : Element(parent, id, focus), heights_(heights) {}
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  virtual std::size_t row_count() const = 0;
  virtual std::size_t columns() const { return 1; }  ///< of rows, side by side
  virtual std::size_t cursor() const = 0;
  virtual void set_cursor(std::size_t row, int modifiers) = 0;
  virtual void choose(std::size_t row, int modifiers) { set_cursor(row, modifiers); }  ///< a click
  virtual void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) = 0;
  virtual void paint_frame(NVGcontext*) const {}  ///< header and footer

  /// A part of the width: column 0 of 3 is the left third.
  struct Place {
    double top, height;  ///< pixels, in the content
    std::size_t column, columns;
  };
  // For rows of other heights, or several side by side. Rows are in order of their tops.
  virtual double content_height() const;  ///< pixels; requires rows
  virtual Place place_of(std::size_t row) const;
  virtual std::size_t row_at_offset(double y) const;  ///< the first there, clamped to the rows
  virtual std::size_t row_below(std::size_t row, int steps) const;  ///< clamped to the rows
  virtual double row_height() const { return heights_.row; }

  const Heights& heights() const { return heights_; }
  void set_footer(double height) { heights_.footer = height; }
  const std::optional<std::size_t>& hovered() const { return hovered_; }
  void clear_hovered() { hovered_.reset(); }
  void scroll_to_top() { scroll_ = {}; }
  void put_on_top(std::size_t row);  ///< requires row < row_count()
  /// Scrolls to the row and returns its rectangle; requires row < row_count().
  ScreenRect bring_into_view(std::size_t row) const;
  std::vector<std::size_t> visible_rows() const;
  std::optional<std::size_t> row_at(const Point& at) const;

  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override { scroll_.drag(at); }
  void release(const Point&) override { scroll_.release(); }
  void hover(const std::optional<Point>& at) override;
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;
  /// Moves the cursor to a row and into view.
  void move_cursor(std::size_t row, int modifiers);

 private:
  std::size_t rows_per_column() const;
  void update_scroll() const;
  ScreenRect view() const;  ///< between header and footer
  ScreenRect row_rect(std::size_t row) const;

  Heights heights_;
  mutable Scroll scroll_;
  std::optional<std::size_t> hovered_;
};

}  // namespace slalom
