#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/run_table.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kIndent = 14;
constexpr float kSize = draw::kSmallTextSize + 1;

void draw_box(NVGcontext* ctx, const ScreenRect& box, bool checked) {
  const Palette& colors = palette();
  draw::fill(ctx, box, checked ? colors.selected : colors.window, 2);
  draw::frame(ctx, box, colors.faint_text);
  if (!checked) return;
  const double x = box.left, y = box.top;
  draw::line(ctx, x + 3, y + 7, x + 6, y + 10, colors.text, 2);
  draw::line(ctx, x + 6, y + 10, x + 11, y + 4, colors.text, 2);
}

ScreenRect in_middle(const ScreenRect& row, double left, double size) {
  return {left, row.top + 0.5 * (row.height - size), size, size};
}

}  // namespace

RunTable::Columns RunTable::columns() const {
  Columns at;
  const double right = width() - kMargin - kScrollBar;
  at.time = right - at.number_width;
  at.length = at.time - at.number_width;
  at.success_width = width() >= 430 ? 64 : 0;
  at.success = at.length - at.success_width;
  at.label = kMargin + 2 * (kBox + 6);
  at.outcome_width = std::min(190.0, 0.5 * (at.success - at.label));
  at.outcome = at.success - at.outcome_width;
  at.label_width = at.outcome - at.label - 6;
  return at;
}

void RunTable::draw_header(NVGcontext* ctx) const {
  const Palette& colors = palette();
  const Columns at = columns();
  draw::fill(ctx, {0, 0, static_cast<double>(width()), kHeaderHeight}, colors.window);
  if (!rows_.empty()) draw_box(ctx, box_of_all(), any_shown());
  const auto title = [&](double left, double wide, const char* name, draw::Align align) {
    if (wide > 0)
      draw::text(ctx, {left, 0, wide, kHeaderHeight}, name, colors.faint_text, draw::kSmallTextSize,
                 align);
  };
  title(at.label, at.label_width, "Method, run", draw::Align::Left);
  title(at.outcome, at.outcome_width, "Outcome", draw::Align::Left);
  title(at.success, at.success_width, "Success", draw::Align::Left);
  title(at.length, at.number_width, "Length m", draw::Align::Right);
  title(at.time, at.number_width, "Time s", draw::Align::Right);
}

void RunTable::draw_row(NVGcontext* ctx, std::size_t index) const {
  const Palette& colors = palette();
  const Columns at = columns();
  const OverlayRow& row = rows_[index];
  const ScreenRect rect = row_rect(index);
  const bool at_cursor = index == cursor_ && has_keyboard();
  draw::fill(ctx, rect,
             hovered_ == index ? colors.hover
             : index % 2 == 0  ? colors.panel
                               : colors.row);
  if (at_cursor) draw::frame(ctx, rect, colors.accent);
  draw_box(ctx, in_middle(rect, kMargin, kBox), row.shown);
  const double indent = row.indented ? kIndent : 0;
  const ScreenRect swatch = in_middle(rect, kMargin + kBox + 6 + indent, kBox);
  draw::fill(ctx, swatch, row.color, 2);
  draw::frame(ctx, swatch, colors.text);
  const nanogui::Color ink = row.shown ? colors.text : colors.disabled_text;
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

void RunTable::draw_detail(NVGcontext* ctx) const {
  const std::size_t row = hovered_.value_or(cursor_);
  if (row >= rows_.size()) return;
  const double top = height() - kDetailHeight;
  draw::line(ctx, 0, top + 0.5, width(), top + 0.5, palette().border);
  draw::wrapped_text(ctx, {kMargin, top + 3, width() - 2 * kMargin, kDetailHeight - 3},
                     rows_[row].detail, palette().faint_text, draw::kSmallTextSize);
}

void RunTable::draw_scroll_bar(NVGcontext* ctx) const {
  const std::size_t seen = visible_rows();
  if (rows_.size() <= seen) return;
  const auto count = static_cast<double>(rows_.size());
  const double room = static_cast<double>(seen) * kRowHeight, left = width() - kScrollBar;
  draw::fill(ctx, {left, kHeaderHeight, kScrollBar, room}, palette().window);
  draw::fill(ctx,
             {left, kHeaderHeight + room * static_cast<double>(first_) / count, kScrollBar,
              room * static_cast<double>(seen) / count},
             palette().faint_text, 3);
}

void RunTable::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  draw_header(ctx);
  for (std::size_t row = first_; row < std::min(rows_.size(), first_ + visible_rows()); ++row)
    draw_row(ctx, row);
  if (rows_.empty())
    draw::wrapped_text(ctx,
                       {kMargin, kHeaderHeight + kMargin, width() - 2 * kMargin,
                        height() - kHeaderHeight - kMargin},
                       message_, palette().faint_text);
  draw_scroll_bar(ctx);
  draw_detail(ctx);
  nvgRestore(ctx);
}

}  // namespace slalom
