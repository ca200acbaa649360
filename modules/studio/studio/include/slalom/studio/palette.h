// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/TColor.h>

#include <array>
#include <string>

namespace slalom {

using Color = mrpt::img::TColor;

enum class Theme { Dark, Light };

inline std::array<const char*, 2> enum_names(Theme) {
  return {"dark", "light"};
}

/// The colors of the window; by default the dark ones. Text on a panel has a contrast of at least
/// 4.5 to 1 (WCAG 2.1, AA). Those of the scenario are the same in all themes.
struct Palette {
  Color window = {0x22, 0x26, 0x2c, 0xff};
  Color panel = {0x2b, 0x30, 0x38, 0xff};
  Color row = {0x30, 0x36, 0x3f, 0xff};       ///< every other row of a list
  Color selected = {0x2f, 0x5d, 0x8c, 0xff};  ///< background of selected rows
  Color hover = {0x3a, 0x42, 0x4d, 0xff};
  Color border = {0x4a, 0x52, 0x5e, 0xff};
  Color text = {0xe8, 0xea, 0xed, 0xff};
  Color faint_text = {0xa9, 0xb1, 0xbc, 0xff};
  Color disabled_text = {0x8a, 0x92, 0x9d, 0xff};
  Color error_text = {0xff, 0x9b, 0x8f, 0xff};
  Color accent = {0x5a, 0xa9, 0xe6, 0xff};

  Color free_space = {0xf4, 0xf4, 0xf0, 0xff};
  Color obstacle = {0x3c, 0x40, 0x46, 0xff};
  Color mover = {0xe0, 0xa0, 0x30, 0xff};
  Color mover_path = {0x8a, 0x5a, 0x00, 0xff};
  Color person = {0xa7, 0x8b, 0xda, 0xff};
  Color person_path = {0x4b, 0x2e, 0x83, 0xff};
  Color outside = {0x55, 0x5b, 0x64, 0xff};
  Color start = {0x1b, 0x7f, 0x3b, 0xff};
  Color goal = {0xb3, 0x26, 0x1e, 0xff};
  Color shortest = {0x14, 0x16, 0x1a, 0xff};  ///< differs from all method colors
  Color safest = {0x8a, 0x3f, 0xc4, 0xff};
  Color published = {0x9a, 0x5b, 0x00, 0xff};
  Color voronoi = {0xd8, 0x3a, 0x8c, 0xff};
  Color scan = {0xd0, 0x60, 0x00, 0xff};
  Color point_cell = {0x9a, 0xa0, 0xa8, 0xff};  ///< a cell that points occupy
  Color edit = {0xe0, 0x7b, 0x00, 0xff};        ///< preview of an edit
};

const Palette& palette_of(Theme theme);

/// The colors of the theme in use.
const Palette& palette();
Theme theme_in_use();
void use_theme(Theme theme);

/// The color with another opacity (0 to 1).
Color faded(const Color& color, double opacity);
/// `from` at 0, `to` at 1, linear between them, also in opacity.
Color interpolated(const Color& from, const Color& to, double fraction);
/// The color of the method with this index among the visible methods; distinct for the first ten.
Color method_line_color(std::size_t index);
/// The color of an outcome such as "success" or "collision".
Color outcome_color(const std::string& outcome);

/// The color of a value as a fraction (0 to 1) of the maximum: from dark blue over green to yellow.
Color heat_color(double fraction);

}  // namespace slalom
