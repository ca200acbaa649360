#include "widgets/drawing.h"
#include "widgets/table.h"

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {

std::size_t Table::rows_per_column() const {
  return (row_count() + columns() - 1) / columns();
}

void Table::update_scroll() const {
  const double middle = height() - heights_.header - heights_.footer;
  scroll_.set(heights_.row * static_cast<double>(rows_per_column()),
              {0, heights_.header, static_cast<double>(width()), std::max(middle, heights_.row)});
}

ScreenRect Table::row_rect(std::size_t row) const {
  const double bar = scroll_.thumb() ? Scroll::kBarWidth : 0;
  const double wide = (width() - bar) / static_cast<double>(columns());
  const std::size_t column = row / rows_per_column();
  return {static_cast<double>(column) * wide,
          heights_.header + heights_.row * static_cast<double>(row % rows_per_column()) -
              scroll_.offset(),
          wide, heights_.row};
}

ScreenRect Table::bring_into_view(std::size_t row) const {
  update_scroll();
  const double top = heights_.row * static_cast<double>(row % rows_per_column());
  scroll_.show(top, top + heights_.row);
  return row_rect(row);
}

std::optional<std::size_t> Table::row_at(const Point& at) const {
  if (at.y < heights_.header || at.y >= height() - heights_.footer) return std::nullopt;
  for (std::size_t row = 0; row < row_count(); ++row)
    if (row_rect(row).contains(at)) return row;
  return std::nullopt;
}

void Table::paint(NVGcontext* ctx) {
  update_scroll();
  draw::fill(ctx, area(), palette().panel);
  nvgSave(ctx);
  draw::clip(ctx, {0, heights_.header, area().width,
                   std::max(height() - heights_.header - heights_.footer, 0.0)});
  for (std::size_t row = 0; row < row_count(); ++row) {
    const ScreenRect rect = row_rect(row);
    if (rect.bottom() > heights_.header && rect.top < height()) paint_row(ctx, row, rect);
  }
  scroll_.draw(ctx);
  nvgRestore(ctx);
  paint_frame(ctx);
}

bool Table::press(const Point& at, int /*modifiers*/) {
  update_scroll();
  if (scroll_.press(at)) return true;
  if (const auto row = row_at(at)) choose(*row);
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
  if (modifiers != 0 || row_count() == 0) return false;
  const std::size_t last = row_count() - 1, now = std::min(cursor(), last);
  std::size_t row = 0;
  switch (key) {
    case GLFW_KEY_UP:
      row = now - std::min<std::size_t>(now, 1);
      break;
    case GLFW_KEY_DOWN:
      row = std::min(now + 1, last);
      break;
    case GLFW_KEY_HOME:
      break;
    case GLFW_KEY_END:
      row = last;
      break;
    default:
      return false;
  }
  hovered_.reset();
  set_cursor(row);
  bring_into_view(row);
  return true;
}

}  // namespace slalom
