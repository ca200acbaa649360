#include <slalom/studio/palette.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace slalom {

Color faded(const Color& color, double opacity) {
  return {color.R, color.G, color.B, static_cast<std::uint8_t>(std::lround(255 * opacity))};
}

Color interpolated(const Color& from, const Color& to, double fraction) {
  const auto between = [fraction](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
  };
  return {between(from.R, to.R), between(from.G, to.G), between(from.B, to.B),
          between(from.A, to.A)};
}

Color method_line_color(std::size_t index) {
  static const std::array<Color, 10> colors = {{{0x00, 0x72, 0xb2, 0xff},
                                                {0xd5, 0x5e, 0x00, 0xff},
                                                {0x00, 0x9e, 0x73, 0xff},
                                                {0xcc, 0x79, 0xa7, 0xff},
                                                {0xe6, 0x9f, 0x00, 0xff},
                                                {0x56, 0xb4, 0xe9, 0xff},
                                                {0x7a, 0x4b, 0x2a, 0xff},
                                                {0x6a, 0x3d, 0x9a, 0xff},
                                                {0x9a, 0xb0, 0x1c, 0xff},
                                                {0xe3, 0x1a, 0x5c, 0xff}}};
  return colors[index % colors.size()];
}

Color outcome_color(const std::string& outcome) {
  static const std::map<std::string, Color> colors = {{"success", {0x2e, 0xa0, 0x4f, 0xff}},
                                                      {"collision", {0xd0, 0x3b, 0x2f, 0xff}},
                                                      {"timeout", {0xd9, 0x8e, 0x04, 0xff}},
                                                      {"stuck", {0xb8, 0x6f, 0x00, 0xff}}};
  const auto found = colors.find(outcome);
  return found == colors.end() ? Color(0x8e, 0x5b, 0xc0, 0xff) : found->second;
}

Color heat_color(double fraction) {
  static const std::array<Color, 4> colors = {{{0x3b, 0x52, 0x8b, 0xff},
                                               {0x21, 0x91, 0x8c, 0xff},
                                               {0x5e, 0xc9, 0x62, 0xff},
                                               {0xfd, 0xe7, 0x25, 0xff}}};
  const double at = std::clamp(fraction, 0.0, 1.0) * (colors.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), colors.size() - 2);
  return interpolated(colors[low], colors[low + 1], at - static_cast<double>(low));
}

}  // namespace slalom
