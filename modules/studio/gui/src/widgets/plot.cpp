// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drawing.h"
#include "widgets/plot.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kLeft = 62, kRight = 16, kTop = 20, kTickRow = 17, kTitleRow = 17;
constexpr double kTickWidth = 84, kTickHeight = 26;

}  // namespace

PlotFrame PlotFrame::within(const ScreenRect& rect, Interval x_range, Interval y_range) {
  const ScreenRect area{rect.left + kLeft, rect.top + kTop,
                        std::max(rect.width - kLeft - kRight, 1.0),
                        std::max(rect.height - kTop - kTickRow - kTitleRow, 1.0)};
  return {area,
          {x_range.first, x_range.second, area.left, area.left + area.width},
          {y_range.first, y_range.second, area.top + area.height, area.top},
          false};
}

void PlotFrame::draw(NVGcontext* ctx, const std::string& x_title,
                     const std::string& y_title) const {
  const Palette& colors = palette();
  const double bottom = area.top + area.height, right = area.left + area.width;
  for (const auto& tick : x.ticks(std::max(1, static_cast<int>(area.width / kTickWidth)))) {
    const double at = x.to_pixel(tick.value);
    draw::line(ctx, at, area.top, at, bottom, colors.hover);
    draw::text(ctx, {at - 0.5 * kTickWidth, bottom + 1, kTickWidth, kTickRow}, tick.label,
               colors.faint_text, draw::kSmallTextSize, draw::Align::Center);
  }
  int max_y_ticks = std::max(1, static_cast<int>(area.height / kTickHeight));
  if (integer_y && y.high() - y.low() < max_y_ticks)
    max_y_ticks = static_cast<int>(std::ceil(y.high() - y.low()));
  for (const auto& tick : y.ticks(max_y_ticks)) {
    const double at = y.to_pixel(tick.value);
    draw::line(ctx, area.left, at, right, at, colors.hover);
    draw::text(ctx, {area.left - kLeft, at - 8, kLeft - 5, 16}, tick.label, colors.faint_text,
               draw::kSmallTextSize, draw::Align::Right);
  }
  draw::frame(ctx, area, colors.border);
  draw::text(ctx, {area.left, bottom + kTickRow, area.width, kTitleRow}, x_title, colors.text,
             draw::kSmallTextSize, draw::Align::Right);
  const double title_left = area.left - kLeft + 8;
  const double title = draw::text_width(ctx, y_title, draw::kSmallTextSize) + 1;
  draw::text(ctx,
             {title_left, area.top - kTop,
              std::max(0.5 * area.width, std::min(title, right - title_left)), kTop - 2},
             y_title, colors.text, draw::kSmallTextSize);
}

void Plot::paint(NVGcontext* ctx) {
  draw::fill(ctx, area(), palette().panel);
  const PlotFrame shown = frame();
  const std::string why = message();
  if (why.empty()) {
    shown.draw(ctx, x_title(), y_title());
    paint_data(ctx, shown);
  } else {
    draw::text(ctx, area(), why, palette().faint_text, draw::kTextSize, draw::Align::Center);
  }
  const double wide = 0.75 * shown.area.right();
  draw::text(ctx, {shown.area.right() - wide, 1, wide, shown.area.top - 2}, remark(),
             palette().faint_text, draw::kSmallTextSize, draw::Align::Right);
}

}  // namespace slalom
