// SPDX-License-Identifier: BSD-3-Clause
#include "views/view_layout.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace slalom {
namespace {

constexpr double kButtonHeight = 26, kGap = 4, kPositionHeight = 24;
constexpr double kLegendRowHeight = 22, kMinLegendRowHeight = 15, kLegendTitleHeight = 24;
constexpr double kClosedLegendWidth = 92, kScaleBarWidth = 220;
/// Room for a character, and the padding of a button (pixels).
constexpr double kCharacterWidth = 7, kPadding = 10;

struct LegendColumns {
  std::size_t count, rows;
  double width, row_height;
};

/// The fewest columns in which all rows are in the canvas and readable.
LegendColumns legend_columns(std::size_t layers, const ScreenRect& canvas, double width) {
  const double wide = canvas.width - 2 * kGap;
  const double tall = canvas.height - 2 * kGap - kLegendTitleHeight;
  for (std::size_t count = 1;; ++count) {
    const std::size_t rows = (layers + count - 1) / count;
    const double row_height = std::min(kLegendRowHeight, tall / static_cast<double>(rows));
    if (row_height < kMinLegendRowHeight && rows > 1) continue;
    return {count, rows, std::min(width, wide / static_cast<double>(count)),
            std::max(row_height, 0.0)};
  }
}

}  // namespace

using mrpt::math::TPoint2D;

ViewTransform::ViewTransform(TPoint2D center, double pixels_per_meter, const ScreenRect& screen)
    : center_(center),
      scale_(std::clamp(pixels_per_meter, kMinScale, kMaxScale)),
      screen_{screen.left, screen.top, std::max(screen.width, 1.0), std::max(screen.height, 1.0)} {}

ViewTransform ViewTransform::fitting(const Bounds& bounds, const ScreenRect& screen,
                                     double margin) {
  const double scale = std::min(std::max(screen.width - 2 * margin, 1.0) / bounds.width(),
                                std::max(screen.height - 2 * margin, 1.0) / bounds.height());
  const TPoint2D center(0.5 * (bounds.x_min + bounds.x_max), 0.5 * (bounds.y_min + bounds.y_max));
  return {center, scale, screen};
}

TPoint2D ViewTransform::to_screen(const TPoint2D& world) const {
  const TPoint2D middle = screen_.center();
  return {middle.x + (world.x - center_.x) * scale_, middle.y - (world.y - center_.y) * scale_};
}

TPoint2D ViewTransform::to_world(const TPoint2D& screen) const {
  const TPoint2D middle = screen_.center();
  return {center_.x + (screen.x - middle.x) / scale_, center_.y - (screen.y - middle.y) / scale_};
}

Bounds ViewTransform::visible() const {
  const TPoint2D low = to_world({screen_.left, screen_.bottom()}),
                 high = to_world({screen_.right(), screen_.top});
  return {low.x, low.y, high.x, high.y};
}

ViewTransform ViewTransform::on(const ScreenRect& screen) const {
  const double ratio = std::min(std::max(screen.width, 1.0) / screen_.width,
                                std::max(screen.height, 1.0) / screen_.height);
  return {center_, scale_ * ratio, screen};
}

ViewTransform ViewTransform::panned(double dx, double dy) const {
  return {{center_.x - dx / scale_, center_.y + dy / scale_}, scale_, screen_};
}

ViewTransform ViewTransform::zoomed(const TPoint2D& about, double factor) const {
  const TPoint2D fixed = to_world(about);
  ViewTransform next(center_, scale_ * factor, screen_);
  const TPoint2D moved = next.to_screen(fixed);
  return next.panned(about.x - moved.x, about.y - moved.y);
}

ScaleBar ScaleBar::choose(double pixels_per_meter, double max_pixels) {
  const double max_meters = max_pixels / pixels_per_meter;
  // 1e-9: a length that fits exactly is not excluded by rounding.
  const double power = math::pow(10.0, std::floor(std::log10(max_meters) + 1e-9));
  double meters = power;
  for (const double step : {2.0, 5.0})
    if (step * power <= max_meters * (1 + 1e-9)) meters = step * power;
  return {meters, meters * pixels_per_meter};
}

std::string ScaleBar::text() const {
  const double factor = meters >= 1000 ? 0.001 : meters >= 1 ? 1 : meters >= 0.01 ? 100 : 1000;
  const char* unit = meters >= 1000 ? "km" : meters >= 1 ? "m" : meters >= 0.01 ? "cm" : "mm";
  char text[48];
  std::snprintf(text, sizeof text, "%g %s", meters * factor, unit);
  return text;
}

ViewLayout::ViewLayout(double width, double height, const std::vector<Button>& buttons,
                       const std::vector<std::string>& layers, double legend_width) {
  tools = {0, 0, width, place_buttons(width, buttons)};
  const double below = std::max(tools.height, height - kPositionHeight);
  const double bar = std::min(kScaleBarWidth, 0.4 * width);
  status = {0, below, width - bar, kPositionHeight};
  scale_bar = {width - bar, below, bar, kPositionHeight};
  canvas = {0, tools.height, width, std::max(1.0, status.top - tools.height)};
  place_legend(layers, legend_width);
}

double ViewLayout::place_buttons(double width, const std::vector<Button>& buttons) {
  double left = kGap, top = kGap;
  for (const Button& button : buttons) {
    const double button_width =
        kCharacterWidth * static_cast<double>(button.title.size()) + kPadding;
    if (left + button_width > width && left > kGap) {
      left = kGap;
      top += kButtonHeight + kGap;
    }
    parts.push_back({button.name, {left, top, button_width, kButtonHeight}});
    left += button_width + kGap;
  }
  return top + kButtonHeight + kGap;
}

void ViewLayout::place_legend(const std::vector<std::string>& layers, double preferred_width) {
  const LegendColumns columns =
      layers.empty() ? LegendColumns{1, 0, kClosedLegendWidth, 0}
                     : legend_columns(layers.size(), canvas, std::max(preferred_width, 1.0));
  const double width = static_cast<double>(columns.count) * columns.width;
  const double left = canvas.right() - width - kGap, top = canvas.top + kGap;
  parts.push_back({"legend", {left, top, width, kLegendTitleHeight}});
  const double rows_top = top + kLegendTitleHeight;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::size_t from_left = i / columns.rows, from_top = i % columns.rows;
    const auto column = static_cast<double>(from_left), row = static_cast<double>(from_top);
    parts.push_back({"layer " + layers[i],
                     {left + column * columns.width, rows_top + row * columns.row_height,
                      columns.width, columns.row_height}});
  }
  legend = {left, top, width,
            kLegendTitleHeight + static_cast<double>(columns.rows) * columns.row_height};
}

ScreenRect ViewLayout::open_canvas() const {
  ScreenRect open = canvas;
  const bool fits = canvas.width > 2.5 * legend.width && legend.height > kLegendTitleHeight;
  if (fits) open.width = legend.left - canvas.left;
  return open;
}

const Element::Part* ViewLayout::at(double x, double y) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Element::Part& part) {
    return part.rect.contains(x, y);
  });
  return found == parts.end() ? nullptr : &*found;
}

const Element::Part* ViewLayout::find(const std::string& name) const {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const Element::Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

}  // namespace slalom
