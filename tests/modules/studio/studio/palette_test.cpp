// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/enum_names.h>
#include <slalom/studio/palette.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Relative luminance, WCAG 2.1.
double luminance(const Color& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.R) + 0.7152 * linear(color.G) + 0.0722 * linear(color.B);
}

/// Contrast ratio, WCAG 2.1.
double contrast(const Color& a, const Color& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

class PaletteTest : public testing::TestWithParam<Theme> {};

TEST_P(PaletteTest, TextIsReadableOnAllThatIsBehindIt) {
  const Palette& colors = palette_of(GetParam());
  for (const Color& text : {colors.text, colors.faint_text, colors.error_text})
    for (const Color& behind : {colors.panel, colors.row, colors.window})
      EXPECT_GE(contrast(text, behind), 4.5);
  for (const Color& behind : {colors.selected, colors.hover})
    EXPECT_GE(contrast(colors.text, behind), 4.5);
  EXPECT_GE(contrast(colors.disabled_text, colors.panel), 4);
  EXPECT_GE(contrast(colors.accent, colors.panel), 3) << "graphical objects";
  EXPECT_GE(contrast(colors.text, colors.outside), 4.5) << "of messages instead of a scenario";
}

INSTANTIATE_TEST_SUITE_P(Themes, PaletteTest, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& theme) { return to_string(theme.param); });

TEST(Palette, AScenarioHasTheSameColorsInAllThemes) {
  const Palette &dark = palette_of(Theme::Dark), &light = palette_of(Theme::Light);
  EXPECT_NE(dark.panel, light.panel);
  EXPECT_EQ(dark.obstacle, light.obstacle);
  EXPECT_EQ(dark.free_space, light.free_space);
}

TEST(Palette, IsThatOfTheThemeInUse) {
  EXPECT_EQ(palette().panel, palette_of(Theme::Dark).panel);
  use_theme(Theme::Light);
  EXPECT_EQ(palette().panel, palette_of(Theme::Light).panel);
  use_theme(Theme::Dark);
}

}  // namespace
}  // namespace slalom
