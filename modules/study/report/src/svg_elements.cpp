// SPDX-License-Identifier: BSD-3-Clause
#include "svg_elements.h"

#include <slalom/io/svg_scene.h>
#include <slalom/results/privileged.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace slalom::svg {
namespace {

constexpr double kText = 12, kDefaultText = 9;  // pixels, and the points that they are in print

/// Points per pixel of a figure.
double scale_of(const FigureStyle& style) {
  return style.font_size / kText;
}

}  // namespace

double width_of(const FigureStyle& style) {
  constexpr double kPointsPerMillimeter = 72 / 25.4;
  return style.width ? *style.width * kPointsPerMillimeter / scale_of(style) : 0;
}

double width_of_text(const std::string& text) {
  return 6.2 * static_cast<double>(text.size());
}

std::string label_of(const FigureStyle& style, const std::string& method) {
  const auto found = style.labels.find(method);
  if (found != style.labels.end()) return found->second;
  const auto unmarked = style.labels.find(unmarked_name(method));
  return unmarked == style.labels.end() ? method : unmarked->second + kPrivilegedMark;
}

std::string document(double width, double height, const std::string& content,
                     const FigureStyle& style) {
  const double scale = style.width ? *style.width / width : scale_of(style);
  const bool is_default = !style.width && style.font_size == kDefaultText;
  const auto printed = [&](double pixels) {
    return is_default ? fmt::format("{:.0f}", pixels)
                      : fmt::format("{:.2f}{}", pixels * scale, style.width ? "mm" : "pt");
  };
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{3}\" height=\"{4}\" font-family=\"sans-serif\" font-size=\"12\">"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>{2}</svg>\n",
      width, height, content, printed(width), printed(height));
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     html_escape(content));
}

std::string segment(double x1, double y1, double x2, double y2, double width,
                    const std::string& color) {
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"{:.1f}\"/>", x1, y1,
      x2, y2, color, width);
}

std::string method_line(const std::string& points, std::size_t index) {
  constexpr std::array kDashes = {"", "7 3", "2 2", "9 3 2 3", "5 2", "12 3", "9 3 2 3 2 3"};
  const std::string dash = kDashes[index % kDashes.size()];
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>",
                     points, method_color(index),
                     dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"");
}

Plot::Plot(const FigureStyle& style) : style_(style) {
  constexpr double kLeastBeside = 240, kLeast = 120, kRight = 15;
  const double width = width_of(style);
  if (width == 0) return;
  below_ = width - kMargin - kLegend < kLeastBeside;
  width_ = std::max(kLeast, width - kMargin - (below_ ? kRight : kLegend));
}

std::string Plot::frame(const std::string& x_label, const std::string& y_label, int lines) const {
  return segment(x(0), y(0), x(1), y(0)) + segment(x(0), y(0), x(0), y(1)) +
         text(x(0.5), y(0) + 20 + 14 * lines, "middle", x_label) +
         text(10, kMargin - 16, "start", y_label);
}

std::string Plot::x_tick(double part, const std::string& label) const {
  return segment(x(part), y(0), x(part), y(0) + 5) + text(x(part), y(0) + 18, "middle", label);
}

std::string Plot::y_tick(double part, const std::string& label) const {
  return segment(x(0) - 5, y(part), x(0), y(part)) + text(x(0) - 8, y(part) + 4, "end", label);
}

std::pair<double, double> Plot::legend(std::size_t index) const {
  if (!below_) return {x(1) + 15, kMargin + kLine * static_cast<double>(index)};
  return {10, y(0) + 84 + kLine * static_cast<double>(index)};
}

std::string Plot::document(const std::string& content, std::size_t legends) const {
  const double bottom = legend(legends).second;
  return svg::document(x(1) + (below_ ? 15 : kLegend), std::max(kHeight + 2 * kMargin, bottom),
                       content, style_);
}

std::string method_key(const Plot& plot, std::size_t index, const std::string& name) {
  constexpr double kLength = 26;
  const auto [left, top] = plot.legend(index);
  return method_line(fmt::format("{0:.1f},{1:.1f} {2:.1f},{1:.1f}", left, top, left + kLength),
                     index) +
         text(left + kLength + 6, top + 4, "start", label_of(plot.style(), name));
}

}  // namespace slalom::svg
