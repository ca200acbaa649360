// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drawing.h"
#include "widgets/table.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {

void Scroll::set(double content_height, const ScreenRect& view) {
  content_ = content_height;
  view_ = view;
  to(offset_);
}

double Scroll::max_offset() const {
  return std::max(content_ - view_.height, 0.0);
}

void Scroll::to(double offset) {
  offset_ = std::clamp(offset, 0.0, max_offset());
}

void Scroll::show(double top, double bottom) {
  to(std::min(std::max(offset_, bottom - view_.height), top));
}

std::optional<ScreenRect> Scroll::thumb() const {
  constexpr double kMinThumb = 28;
  if (max_offset() <= 0) return std::nullopt;
  const double length =
      std::min(std::max(view_.height * view_.height / content_, kMinThumb), view_.height);
  const double top = view_.top + (view_.height - length) * offset_ / max_offset();
  return ScreenRect{view_.right() - kBarWidth, top, kBarWidth, length};
}

void Scroll::draw(NVGcontext* ctx) const {
  const auto shown = thumb();
  if (!shown) return;
  draw::fill(ctx, {shown->left, view_.top, kBarWidth, view_.height}, palette().window);
  draw::fill(ctx, {shown->left + 2, shown->top + 1, kBarWidth - 4, shown->height - 2},
             grip_ ? palette().accent : palette().faint_text, 3);
}

bool Scroll::press(const Element::Point& at) {
  const auto shown = thumb();
  if (!shown || at.x < shown->left || !view_.contains(at)) return false;
  if (shown->contains(at))
    grip_ = at.y - shown->top;
  else
    by(at.y < shown->top ? -view_.height : view_.height);
  return true;
}

bool Scroll::drag(const Element::Point& at) {
  const auto shown = thumb();
  if (!grip_ || !shown) return false;
  to((at.y - *grip_ - view_.top) / std::max(view_.height - shown->height, 1.0) * max_offset());
  return true;
}

std::size_t Table::rows_per_column() const {
  return (row_count() + columns() - 1) / columns();
}

ScreenRect Table::view() const {
  return {0, heights_.header, area().width,
          std::max(height() - heights_.header - heights_.footer, 0.0)};
}

void Table::update_scroll() const {
  ScreenRect shown = view();
  shown.height = std::max(shown.height, row_height());
  scroll_.set(row_count() == 0 ? 0 : content_height(), shown);
}

double Table::content_height() const {
  return heights_.row * static_cast<double>(rows_per_column());
}

Table::Place Table::place_of(std::size_t row) const {
  return {heights_.row * static_cast<double>(row % rows_per_column()), heights_.row,
          row / rows_per_column(), columns()};
}

std::size_t Table::row_at_offset(double y) const {
  const auto row = static_cast<std::size_t>(std::max(y, 0.0) / heights_.row);
  return std::min(row, rows_per_column() - 1);
}

ScreenRect Table::row_rect(std::size_t row) const {
  const double bar = scroll_.thumb() ? Scroll::kBarWidth : 0;
  const Place place = place_of(row);
  const double wide = (width() - bar) / static_cast<double>(place.columns);
  return {static_cast<double>(place.column) * wide,
          heights_.header + std::round(place.top - scroll_.offset()), wide, place.height};
}

std::optional<ScreenRect> Table::rect_of(const std::string& part) const {
  update_scroll();
  return part == "bar" ? scroll_.thumb() : Element::rect_of(part);
}

ScreenRect Table::bring_into_view(std::size_t row) const {
  update_scroll();
  const Place place = place_of(row);
  scroll_.show(place.top, place.top + place.height);
  return row_rect(row);
}

void Table::put_on_top(std::size_t row) {
  update_scroll();
  scroll_.to(place_of(row).top);
}

std::size_t Table::row_below(std::size_t row, int steps) const {
  const auto to = static_cast<std::ptrdiff_t>(row) + steps;
  return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(to, 0)), row_count() - 1);
}

std::vector<std::size_t> Table::visible_rows() const {
  update_scroll();
  std::vector<std::size_t> rows;
  for (std::size_t first = 0; first < row_count(); first += rows_per_column()) {
    const std::size_t end = std::min(first + rows_per_column(), row_count());
    for (std::size_t row = first + row_at_offset(scroll_.offset());
         row < end && row_rect(row).top < view().bottom(); ++row)
      rows.push_back(row);
  }
  return rows;
}

std::optional<std::size_t> Table::row_at(const Point& at) const {
  if (!view().contains(at)) return std::nullopt;
  for (const std::size_t row : visible_rows())
    if (row_rect(row).contains(at)) return row;
  return std::nullopt;
}

void Table::paint(NVGcontext* ctx) {
  draw::fill(ctx, area(), palette().panel);
  nvgSave(ctx);
  draw::clip(ctx, view());
  for (const std::size_t row : visible_rows()) paint_row(ctx, row, row_rect(row));
  scroll_.draw(ctx);
  nvgRestore(ctx);
  paint_frame(ctx);
}

bool Table::press(const Point& at, int modifiers) {
  update_scroll();
  if (scroll_.press(at)) return true;
  if (const auto row = row_at(at)) choose(*row, modifiers);
  return true;
}

void Table::hover(const std::optional<Point>& at) {
  hovered_ = at ? row_at(*at) : std::nullopt;
}

bool Table::wheel(const Point& at, double steps) {
  update_scroll();
  scroll_.wheel(steps);
  hover(at);
  return true;
}

bool Table::key(int key, int modifiers) {
  if (row_count() == 0) return false;
  const std::size_t last = row_count() - 1, now = std::min(cursor(), last);
  const auto page = static_cast<int>(std::max(view().height / row_height() - 1, 1.0));
  const auto go_to = [&](std::size_t row) { move_cursor(row, modifiers); };
  return run_key(key, {{{GLFW_KEY_UP}, [&] { go_to(row_below(now, -1)); }},
                       {{GLFW_KEY_DOWN}, [&] { go_to(row_below(now, 1)); }},
                       {{GLFW_KEY_PAGE_UP}, [&] { go_to(row_below(now, -page)); }},
                       {{GLFW_KEY_PAGE_DOWN}, [&] { go_to(row_below(now, page)); }},
                       {{GLFW_KEY_HOME}, [&] { go_to(0); }},
                       {{GLFW_KEY_END}, [&] { go_to(last); }}});
}

void Table::move_cursor(std::size_t row, int modifiers) {
  hovered_.reset();
  set_cursor(row, modifiers);
  bring_into_view(row);
}

}  // namespace slalom
