#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/run_table.h>

#include <algorithm>
#include <cstdio>

namespace slalom {
namespace {

constexpr double kRowHeight = 24, kHeaderHeight = 24, kDetailHeight = 40, kMargin = 6;
constexpr double kBox = 14, kIndent = 14, kScrollBar = 6;
constexpr float kSize = draw::kSmallTextSize + 1;

std::string shown_value(const Value& value, bool group) {
  if (group) return "";
  if (value.is_na()) return "NA";
  char number[32];
  std::snprintf(number, sizeof number, "%.2f", value.number());
  return number;
}

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

/// Left edges; a column that has no place has the width 0.
struct RunTable::Columns {
  double label = 0, label_width = 0, outcome = 0, outcome_width = 0;
  double success = 0, success_width = 0, length = 0, time = 0, number_width = 66;
};

RunTable::RunTable(nanogui::Widget* parent, ResultsOverlay& overlay)
    : Element(parent, "runs"), overlay_(overlay) {}

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

void RunTable::set_message(std::string message) {
  message_ = std::move(message);
}

void RunTable::refresh() {
  rows_ = overlay_.rows();
  cursor_ = std::min(cursor_, rows_.empty() ? 0 : rows_.size() - 1);
  hovered_.reset();
  scroll_to(static_cast<std::ptrdiff_t>(first_));
}

void RunTable::changed() {
  rows_ = overlay_.rows();
  if (on_changed) on_changed();
}

void RunTable::move_cursor(int steps) {
  if (rows_.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(rows_.size()) - 1;
  cursor_ = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(cursor_) + steps, 0, last));
  hovered_.reset();
  keep_cursor_visible();
}

void RunTable::toggle_cursor() {
  if (cursor_ >= rows_.size()) return;
  overlay_.toggle(rows_[cursor_]);
  changed();
}

bool RunTable::any_shown() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const OverlayRow& row) { return row.shown; });
}

void RunTable::toggle_all() {
  overlay_.show_all(!any_shown());
  changed();
}

std::size_t RunTable::visible_rows() const {
  const double room = height() - kHeaderHeight - kDetailHeight;
  return static_cast<std::size_t>(std::max(room / kRowHeight, 1.0));
}

void RunTable::scroll_to(std::ptrdiff_t first) {
  const auto most =
      static_cast<std::ptrdiff_t>(rows_.size()) - static_cast<std::ptrdiff_t>(visible_rows());
  first_ = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(first, 0, std::max<std::ptrdiff_t>(most, 0)));
}

void RunTable::keep_cursor_visible() {
  const auto cursor = static_cast<std::ptrdiff_t>(cursor_);
  const auto seen = static_cast<std::ptrdiff_t>(visible_rows());
  const auto first = static_cast<std::ptrdiff_t>(first_);
  scroll_to(std::clamp(first, cursor - seen + 1, cursor));
}

ScreenRect RunTable::box_of_all() const {
  return {kMargin, 0.5 * (kHeaderHeight - kBox), kBox, kBox};
}

ScreenRect RunTable::row_rect(std::size_t row) const {
  const double top = kHeaderHeight + static_cast<double>(row - first_) * kRowHeight;
  return {0, top, static_cast<double>(width()), kRowHeight};
}

std::optional<std::size_t> RunTable::row_at(const nanogui::Vector2i& p) const {
  for (std::size_t row = first_; row < std::min(rows_.size(), first_ + visible_rows()); ++row)
    if (row_rect(row).contains(p.x() - mPos.x(), p.y() - mPos.y())) return row;
  return std::nullopt;
}

std::optional<ScreenRect> RunTable::rect_of(const std::string& part) const {
  if (part == "all") return box_of_all();
  for (std::size_t row = first_; row < std::min(rows_.size(), first_ + visible_rows()); ++row)
    if (part == "row " + std::to_string(row) || part == "row " + rows_[row].label)
      return row_rect(row);
  return Element::rect_of(part);
}

std::string RunTable::text() const {
  if (rows_.empty()) return message_;
  std::string text;
  for (const OverlayRow& row : rows_) {
    text += row.label + (row.shown ? ": shown, " : ": hidden, ") + row.outcome + ", success " +
            row.success;
    if (!row.group)
      text += ", length " + shown_value(row.length, false) + " m, time " +
              shown_value(row.time, false) + " s";
    text += "\n";
  }
  text.pop_back();
  return text;
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
  const bool at_cursor = focused() && index == cursor_;
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
  cell(at.outcome + 16, at.outcome_width - 22, row.outcome, draw::Align::Left);
  cell(at.success, at.success_width, row.success, draw::Align::Left);
  cell(at.length, at.number_width, shown_value(row.length, row.group), draw::Align::Right);
  cell(at.time, at.number_width, shown_value(row.time, row.group), draw::Align::Right);
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

bool RunTable::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int) {
  if (button != GLFW_MOUSE_BUTTON_LEFT || !down) return true;
  if (!focused()) requestFocus();
  if (const auto row = row_at(p)) {
    cursor_ = *row;
    toggle_cursor();
  } else if (box_of_all().contains(p.x() - mPos.x(), p.y() - mPos.y())) {
    toggle_all();
  }
  return true;
}

bool RunTable::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i&, int, int) {
  hovered_ = row_at(p);
  return true;
}

bool RunTable::mouseEnterEvent(const nanogui::Vector2i&, bool enter) {
  if (!enter) hovered_.reset();
  return true;
}

bool RunTable::scrollEvent(const nanogui::Vector2i&, const nanogui::Vector2f& rel) {
  scroll_to(static_cast<std::ptrdiff_t>(first_) - (rel.y() > 0 ? 3 : -3));
  return true;
}

bool RunTable::keyboardEvent(int key, int, int action, int modifiers) {
  if (action == GLFW_RELEASE || modifiers != 0) return false;
  const int all = static_cast<int>(rows_.size());
  switch (key) {
    case GLFW_KEY_UP:
      move_cursor(-1);
      return true;
    case GLFW_KEY_DOWN:
      move_cursor(1);
      return true;
    case GLFW_KEY_HOME:
      move_cursor(-all);
      return true;
    case GLFW_KEY_END:
      move_cursor(all);
      return true;
    case GLFW_KEY_SPACE:
      toggle_cursor();
      return true;
    case GLFW_KEY_A:
      toggle_all();
      return true;
    default:
      return false;
  }
}

}  // namespace slalom
