#include <slalom/gui/run_table.h>

#include <algorithm>
#include <cstdio>

namespace slalom {

RunTable::RunTable(nanogui::Widget* parent, ResultsOverlay& overlay)
    : Element(parent, "runs"), overlay_(overlay) {}

std::string RunTable::shown_value(const Value& value) {
  if (value.is_na()) return "NA";
  char number[32];
  std::snprintf(number, sizeof number, "%.2f", value.number());
  return number;
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

/// The panel around it hands keys on, unless another of its elements has the focus.
bool RunTable::has_keyboard() const {
  const auto& beside = parent()->children();
  return focused() || (parent()->focused() &&
                       std::none_of(beside.begin(), beside.end(),
                                    [](const Widget* widget) { return widget->focused(); }));
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
      text += ", length " + shown_value(row.length) + " m, time " + shown_value(row.time) + " s";
    text += "\n";
  }
  text.pop_back();
  return text;
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
