// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"
#include "widgets/menu.h"

#include <slalom/studio/actions.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cstdio>

namespace slalom {
namespace {

constexpr double kRunRowHeight = 24, kRunHeaderHeight = 24, kDetailHeight = 40, kRunMargin = 6;
constexpr double kIndent = 14, kSwatch = 14;  ///< pixels
constexpr double kRunMenuWidth = 300, kMinRunMenuHeight = 76;
constexpr float kSize = draw::kSmallTextSize + 1;

std::string shown_value(const Value& value) {
  if (value.is_na()) return "NA";
  char number[32];
  std::snprintf(number, sizeof number, "%.2f", value.number());
  return number;
}

ScreenRect in_middle(const ScreenRect& row, double left, double size) {
  return {left, row.top + 0.5 * (row.height - size), size, size};
}

/// The recorded runs, one per row: a checkbox for its visibility, the color of its method, the
/// outcome as color and text, length and time. A click with the right button opens the menu of a
/// run. Keys when it has the focus: those of Table, Space (show or hide), A (all or none).
///
/// Parts: "all" (the checkbox of all runs), "row 0", "row 1", ..., or by the label: "row nd 3". The
/// menu is the element "run_menu".
class RunTable : public Table {
 public:
  RunTable(nanogui::Widget* parent, Studio& studio)
      : Table(parent, "runs", {kRunHeaderHeight, kRunRowHeight, kDetailHeight}, Focus::OnPress),
        studio_(studio),
        results_(studio.results()),
        menu_(new Menu(this, "run_menu", this)) {
    studio.events().observe({Change::Runs}, [this] { refresh(); });
  }
  std::string text() const override {
    if (rows_.empty()) return results_.message();
    std::string text;
    for (const OverlayRow& row : rows_) {
      text += row.label + (row.shown ? ": shown, " : ": hidden, ") + row.outcome + ", success " +
              row.success;
      if (!row.group)
        text += ", length " + shown_value(row.length) + " m, time " + shown_value(row.time) + " s";
      text += "\n";
    }
    text.pop_back();
    return text;
  }
  std::optional<ScreenRect> rect_of(const std::string& part) const override {
    if (part == "all") return all_box();
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (part == "row " + std::to_string(row) || part == "row " + rows_[row].label)
        return bring_into_view(row);
    return Table::rect_of(part);
  }

 protected:
  std::size_t row_count() const override { return rows_.size(); }
  std::size_t cursor() const override { return cursor_; }
  void set_cursor(std::size_t row, int /*modifiers*/) override {
    cursor_ = row;
    select_run();
  }
  void choose(std::size_t row, int modifiers) override {
    set_cursor(row, modifiers);
    results_.toggle(rows_[row]);
  }
  void paint_row(NVGcontext* ctx, std::size_t index, const ScreenRect& rect) override {
    const Palette& colors = palette();
    const Columns at = columns_of_row();
    const OverlayRow& row = rows_[index];
    draw::row(ctx, rect, index, false, hovered() == index);
    if (index == cursor_ && has_keyboard()) draw::frame(ctx, rect, colors.accent);
    draw::check_box(ctx, rect.inset(kRunMargin), row.shown);
    const double indent = row.indented ? kIndent : 0;
    const ScreenRect swatch = in_middle(rect, kRunMargin + draw::kCheckBox + 6 + indent, kSwatch);
    draw::fill(ctx, swatch, row.color, 2);
    draw::frame(ctx, swatch, colors.text);
    const Color& ink = row.shown ? colors.text : colors.disabled_text;
    const auto cell = [&](double left, double wide, const std::string& text, draw::Align align) {
      if (wide > 0) draw::text(ctx, {left, rect.top, wide, rect.height}, text, ink, kSize, align);
    };
    cell(at.label + indent, at.label_width - indent, row.label, draw::Align::Left);
    draw::fill(ctx, in_middle(rect, at.outcome, 10),
               row.outcome == "mixed" ? colors.faint_text : outcome_color(row.outcome), 5);
    const bool counted = row.group && at.success_width == 0;
    cell(at.outcome + 16, (counted ? at.time : at.success) - at.outcome - 22,
         counted ? row.success + " succeed" : row.outcome, draw::Align::Left);
    cell(at.success, at.success_width, row.success, draw::Align::Left);
    cell(at.length, at.number_width, row.group ? "" : shown_value(row.length), draw::Align::Right);
    cell(at.time, at.number_width, row.group ? "" : shown_value(row.time), draw::Align::Right);
  }
  void paint_frame(NVGcontext* ctx) const override {
    draw_header(ctx);
    const double top = height() - kDetailHeight;
    const ScreenRect below{kRunMargin, top + 3, width() - 2 * kRunMargin, kDetailHeight - 3};
    if (rows_.empty()) {
      draw::wrapped_text(ctx, {kRunMargin, kRunHeaderHeight + kRunMargin, below.width, top},
                         results_.message(), palette().faint_text);
      return;
    }
    draw::line(ctx, 0, top + 0.5, width(), top + 0.5, palette().border);
    draw::wrapped_text(ctx, below, rows_[hovered().value_or(cursor_)].detail, palette().faint_text,
                       draw::kSmallTextSize);
  }
  bool press(const Point& at, int modifiers) override {
    if (!all_box().contains(at)) return Table::press(at, modifiers);
    results_.show_all(!any_shown());
    return true;
  }
  void press_right(const Point& at) override {
    const auto row = row_at(at);
    if (!row || !studio_.services().shrink_run) return;
    set_cursor(*row, 0);
    const double wide = std::min(kRunMenuWidth, area().width);
    const Point corner(std::min(at.x, area().width - wide),
                       std::max(std::min(at.y, area().height - kMinRunMenuHeight), 0.0));
    menu_->open(
        corner, wide, area().height,
        {{"shrink", "Shrink...", "", "Finds the smallest scenario that reproduces the failure.",
          [this] { return shrink_disabled_reason(studio_); }}},
        0, [this](std::size_t) { open_shrink_form(studio_); });
  }
  bool key(int key, int modifiers) override {
    if (menu_->visible()) return menu_->key(key, modifiers);
    if (modifiers != 0) return false;
    if (key == GLFW_KEY_SPACE && !rows_.empty()) choose(cursor_, 0);
    if (key == GLFW_KEY_A) results_.show_all(!any_shown());
    return key == GLFW_KEY_SPACE || key == GLFW_KEY_A || Table::key(key, modifiers);
  }

 private:
  /// Left edges and widths; a column that does not fit has the width 0.
  struct Columns {
    double label = 0, label_width = 0, outcome = 0, outcome_width = 0;
    double success = 0, success_width = 0, length = 0, time = 0, number_width = 66;
  };
  void refresh() {
    rows_ = results_.overlay().rows();
    cursor_ = std::min(cursor_, rows_.empty() ? 0 : rows_.size() - 1);
    clear_hovered();
    menu_->close();
    select_run();
  }
  void select_run() {
    const bool one = !rows_.empty() && rows_[cursor_].runs.size() == 1;
    results_.overlay().select(one ? std::optional(rows_[cursor_].runs.front()) : std::nullopt);
  }
  Columns columns_of_row() const {
    Columns at;
    const double right = width() - kRunMargin - Scroll::kBarWidth;
    at.time = right - at.number_width;
    at.length = at.time - at.number_width;
    at.success_width = width() >= 430 ? 64 : 0;
    at.success = at.length - at.success_width;
    at.label = kRunMargin + 2 * (draw::kCheckBox + 6);
    at.outcome_width = std::min(190.0, 0.5 * (at.success - at.label));
    at.outcome = at.success - at.outcome_width;
    at.label_width = at.outcome - at.label - 6;
    return at;
  }
  bool any_shown() const {
    return std::any_of(rows_.begin(), rows_.end(), [](const OverlayRow& row) { return row.shown; });
  }
  /// Also if the parent panel has the focus, which forwards keys, and none of its elements has it.
  bool has_keyboard() const {
    const auto& siblings = parent()->children();
    return focused() || (parent()->focused() &&
                         std::none_of(siblings.begin(), siblings.end(),
                                      [](const Widget* widget) { return widget->focused(); }));
  }
  ScreenRect all_box() const {
    return in_middle({0, 0, area().width, kRunHeaderHeight}, kRunMargin, draw::kCheckBox);
  }
  void draw_header(NVGcontext* ctx) const {
    const Palette& colors = palette();
    const Columns at = columns_of_row();
    draw::fill(ctx, {0, 0, area().width, kRunHeaderHeight}, colors.window);
    if (!rows_.empty()) draw::check_box(ctx, all_box(), any_shown());
    const auto title = [&](double left, double wide, const char* name, draw::Align align) {
      if (wide > 0)
        draw::text(ctx, {left, 0, wide, kRunHeaderHeight}, name, colors.faint_text,
                   draw::kSmallTextSize, align);
    };
    title(at.label, at.label_width, "Method, run", draw::Align::Left);
    title(at.outcome, at.outcome_width, "Outcome", draw::Align::Left);
    title(at.success, at.success_width, "Success", draw::Align::Left);
    title(at.length, at.number_width, "Length m", draw::Align::Right);
    title(at.time, at.number_width, "Time s", draw::Align::Right);
  }

  Studio& studio_;
  ResultsLoader& results_;
  Menu* menu_;
  std::vector<OverlayRow> rows_;
  std::size_t cursor_ = 0;
};

}  // namespace

Element* make_run_table(nanogui::Widget* parent, Studio& studio) {
  return new RunTable(parent, studio);
}

}  // namespace slalom
