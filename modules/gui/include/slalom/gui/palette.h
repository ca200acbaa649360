#pragma once

#include <nanogui/nanogui.h>
#include <string>

namespace slalom {

/// The window's colours. Text on a panel has a contrast of at least 4.5 to 1 (WCAG 2.1, AA).
struct Palette {
  nanogui::Color window = {0x22, 0x26, 0x2c, 0xff};
  nanogui::Color panel = {0x2b, 0x30, 0x38, 0xff};
  nanogui::Color row = {0x30, 0x36, 0x3f, 0xff};       ///< every other row of a list
  nanogui::Color selected = {0x2f, 0x5d, 0x8c, 0xff};  ///< behind what is selected
  nanogui::Color hover = {0x3a, 0x42, 0x4d, 0xff};
  nanogui::Color border = {0x4a, 0x52, 0x5e, 0xff};
  nanogui::Color text = {0xe8, 0xea, 0xed, 0xff};
  nanogui::Color faint_text = {0xa9, 0xb1, 0xbc, 0xff};
  nanogui::Color disabled_text = {0x8a, 0x92, 0x9d, 0xff};
  nanogui::Color error_text = {0xff, 0x9b, 0x8f, 0xff};
  nanogui::Color accent = {0x5a, 0xa9, 0xe6, 0xff};

  nanogui::Color floor = {0xf4, 0xf4, 0xf0, 0xff};  ///< free space of a scenario
  nanogui::Color obstacle = {0x3c, 0x40, 0x46, 0xff};
  nanogui::Color outside = {0x55, 0x5b, 0x64, 0xff};
  nanogui::Color start = {0x1b, 0x7f, 0x3b, 0xff};
  nanogui::Color goal = {0xb3, 0x26, 0x1e, 0xff};
  nanogui::Color shortest = {0x14, 0x16, 0x1a, 0xff};  ///< unlike every method
  nanogui::Color safest = {0x8a, 0x3f, 0xc4, 0xff};
  nanogui::Color published = {0x9a, 0x5b, 0x00, 0xff};
  nanogui::Color voronoi = {0xd8, 0x3a, 0x8c, 0xff};
  nanogui::Color scan = {0xd0, 0x60, 0x00, 0xff};
  nanogui::Color point_cell = {0x9a, 0xa0, 0xa8, 0xff};  ///< a cell that points occupy
  nanogui::Color edit = {0xe0, 0x7b, 0x00, 0xff};        ///< what an edit is about to change
};

inline const Palette& palette() {
  static const Palette colors;
  return colors;
}

/// Of the method at this place among the methods that are shown; distinct for the first ten.
nanogui::Color method_line_color(std::size_t index);
/// Of an outcome such as "success" or "collision".
nanogui::Color outcome_color(const std::string& outcome);

/// Of a share (0 to 1) of the largest value: blue, green, yellow, lighter as it grows.
nanogui::Color heat_color(double share);

}  // namespace slalom
