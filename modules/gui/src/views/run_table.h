#pragma once

#include "widgets/table.h"

#include <slalom/studio/results_overlay.h>

#include <string>
#include <vector>

namespace slalom {

/// The recorded runs, one per row: a checkbox for its visibility, the color of its method, the
/// outcome as color and text, length and time. Keys when it has the focus: those of
/// Table, Space (show or hide), A (all or none).
///
/// Parts: "all" (the checkbox of all runs), "row 0", "row 1", ..., or by the label: "row nd 3".
class RunTable : public Table {
 public:
  RunTable(nanogui::Widget* parent, ResultsLoader& results);
  void refresh();  ///< after a change of the runs
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  std::size_t row_count() const override { return rows_.size(); }
  std::size_t cursor() const override { return cursor_; }
  void set_cursor(std::size_t row, int /*modifiers*/) override { cursor_ = row; }
  void choose(std::size_t row, int modifiers) override;
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) override;
  void paint_frame(NVGcontext* ctx) const override;
  bool press(const Point& at, int modifiers) override;
  bool key(int key, int modifiers) override;

 private:
  /// Left edges and widths; a column that does not fit has the width 0.
  struct Columns {
    double label = 0, label_width = 0, outcome = 0, outcome_width = 0;
    double success = 0, success_width = 0, length = 0, time = 0, number_width = 66;
  };
  Columns columns_of_row() const;
  bool any_shown() const;
  bool has_keyboard() const;
  ScreenRect all_box() const;
  void draw_header(NVGcontext* ctx) const;

  ResultsLoader& results_;
  std::vector<OverlayRow> rows_;
  std::size_t cursor_ = 0;
};

}  // namespace slalom
