#include "views/view_layout.h"

#include <algorithm>

namespace slalom {
namespace {

constexpr double kButtonHeight = 26, kGap = 4, kPositionHeight = 24;
constexpr double kLegendWidth = 250, kLegendRowHeight = 22, kLegendTitleHeight = 24;
constexpr double kClosedLegendWidth = 92, kScaleBarWidth = 220;
/// Upper bound of the width of a character, and the padding of a button (pixels).
constexpr double kCharacterWidth = 8, kPadding = 16;

}  // namespace

ViewLayout::ViewLayout(double width, double height, const std::vector<Button>& buttons,
                       const std::vector<std::string>& layers) {
  tools = {0, 0, width, place_buttons(width, buttons)};
  const double below = std::max(tools.height, height - kPositionHeight);
  const double bar = std::min(kScaleBarWidth, 0.4 * width);
  status = {0, below, width - bar, kPositionHeight};
  scale_bar = {width - bar, below, bar, kPositionHeight};
  canvas = {0, tools.height, width, std::max(1.0, status.top - tools.height)};
  place_legend(layers);
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

void ViewLayout::place_legend(const std::vector<std::string>& layers) {
  const double width =
      std::min(layers.empty() ? kClosedLegendWidth : kLegendWidth, canvas.width - 2 * kGap);
  const double left = canvas.left + canvas.width - width - kGap, top = canvas.top + kGap;
  parts.push_back({"legend", {left, top, width, kLegendTitleHeight}});
  double row = top + kLegendTitleHeight;
  for (const std::string& layer : layers) {
    if (row + kLegendRowHeight > canvas.top + canvas.height) break;
    parts.push_back({"layer " + layer, {left, row, width, kLegendRowHeight}});
    row += kLegendRowHeight;
  }
  legend = {left, top, width, row - top};
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
