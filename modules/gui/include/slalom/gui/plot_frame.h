#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/plot_axes.h>

#include <string>
#include <utility>

namespace slalom {

/// The area of a plot within an element, with its two axes, in the element's pixels.
struct PlotFrame {
  ScreenRect area;
  PlotAxis x, y;
  bool whole_y = false;  ///< counts: no ticks between whole numbers

  /// Leaves room for ticks and titles within `rect`: the y title stands above the axis, the x title
  /// at the right below it.
  static PlotFrame within(const ScreenRect& rect, std::pair<double, double> x_range,
                          std::pair<double, double> y_range);

  /// Ground, grid lines, ticks, titles. `ctx` is in the element's pixels.
  void draw(NVGcontext* ctx, const std::string& x_title, const std::string& y_title) const;
};

/// Of what is pointed out in a plot: the current scenario, a selection.
const nanogui::Color& plot_mark_color();

/// "Clearance (m)"; without the unit where there is none ("-").
std::string with_unit(const std::string& name, const std::string& unit);

}  // namespace slalom
