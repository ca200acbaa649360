// SPDX-License-Identifier: BSD-3-Clause
#include "svg_elements.h"

#include <slalom/io/svg_scene.h>

#include <fmt/format.h>

#include <array>

namespace slalom::svg {

std::string document(double width, double height, const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>{2}</svg>\n",
      width, height, content);
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

std::string method_key(double left, double top, std::size_t index, const std::string& name,
                       double length) {
  return method_line(fmt::format("{0:.1f},{1:.1f} {2:.1f},{1:.1f}", left, top, left + length),
                     index) +
         text(left + length + 6, top + 4, "start", name);
}

}  // namespace slalom::svg
