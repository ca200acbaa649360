// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/svg_scene.h>
#include <slalom/studio/palette.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace slalom {
namespace {

/// An opaque color from 0xRRGGBB.
Color rgb(unsigned code) {
  const auto channel = [code](unsigned shift) {
    return static_cast<std::uint8_t>((code >> shift) & 0xFFU);
  };
  return {channel(16), channel(8), channel(0), 0xff};
}

Palette light_palette() {
  Palette colors;
  colors.window = rgb(0xe4e7eb);
  colors.panel = rgb(0xf5f6f8);
  colors.row = rgb(0xebeef1);
  colors.selected = rgb(0xb5d5f2);
  colors.hover = rgb(0xdde2e8);
  colors.border = rgb(0xb4bcc6);
  colors.text = rgb(0x1b1f24);
  colors.faint_text = rgb(0x515963);
  colors.disabled_text = rgb(0x656d77);
  colors.error_text = rgb(0xb42318);
  colors.accent = rgb(0x0b62ab);
  colors.outside = rgb(0xc6ccd4);
  return colors;
}

Theme used_theme = Theme::Dark;

}  // namespace

const Palette& palette_of(Theme theme) {
  static const Palette dark, light = light_palette();
  return theme == Theme::Dark ? dark : light;
}

const Palette& palette() {
  return palette_of(used_theme);
}

Theme theme_in_use() {
  return used_theme;
}

void use_theme(Theme theme) {
  used_theme = theme;
}

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
  return rgb(static_cast<unsigned>(std::stoul(method_color(index).substr(1), nullptr, 16)));
}

Color outcome_color(const std::string& outcome) {
  if (outcome == "success") return rgb(0x2ea04f);
  if (outcome == "collision") return rgb(0xd03b2f);
  if (outcome == "timeout") return rgb(0xd98e04);
  return rgb(outcome == "stuck" ? 0xb86f00 : 0x8e5bc0);
}

Color heat_color(double fraction) {
  constexpr std::array<unsigned, 4> kColors = {0x3b528b, 0x21918c, 0x5ec962, 0xfde725};
  const double at = std::clamp(fraction, 0.0, 1.0) * (kColors.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kColors.size() - 2);
  return interpolated(rgb(kColors[low]), rgb(kColors[low + 1]), at - static_cast<double>(low));
}

}  // namespace slalom
