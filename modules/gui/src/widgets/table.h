#pragma once

#include "widgets/scroll.h"

#include <cstddef>

namespace slalom {

/// Rows of equal height that scroll between a header and a footer; one of them has the cursor.
/// Keys: Up, Down, Home, End.
class Table : public Element {
 public:
  struct Heights {
    double header, row, footer;  ///< pixels
  };
  Table(nanogui::Widget* parent, const std::string& id, const Heights& heights,
        Focus focus = Focus::None)
      : Element(parent, id, focus), heights_(heights) {}

 protected:
  virtual std::size_t row_count() const = 0;
  virtual std::size_t columns() const { return 1; }  ///< of rows, side by side
  virtual std::size_t cursor() const = 0;
  virtual void set_cursor(std::size_t row) = 0;
  virtual void choose(std::size_t row) { set_cursor(row); }  ///< by a click
  virtual void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const = 0;
  virtual void paint_frame(NVGcontext* ctx) const = 0;  ///< header and footer

  const Heights& heights() const { return heights_; }
  void set_footer(double height) { heights_.footer = height; }
  const std::optional<std::size_t>& hovered() const { return hovered_; }
  /// Scrolls to the row and returns its rectangle; requires row < row_count().
  ScreenRect bring_into_view(std::size_t row) const;
  void set_hovered(std::optional<std::size_t> row) { hovered_ = row; }

  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override { scroll_.drag(at); }
  void release(const Point&) override { scroll_.release(); }
  void hover(const std::optional<Point>& at) override;
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;

 private:
  std::size_t rows_per_column() const;
  void update_scroll() const;
  ScreenRect row_rect(std::size_t row) const;
  std::optional<std::size_t> row_at(const Point& at) const;

  Heights heights_;
  mutable Scroll scroll_;
  std::optional<std::size_t> hovered_;
};

}  // namespace slalom
