// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/palette.h>
#include <slalom/studio/plot_data.h>

#include <string>
#include <utility>

namespace slalom {

/// The area of a plot within an element, with its two axes, in the element's pixels.
struct PlotFrame {
  ScreenRect area;
  PlotAxis x, y;
  bool integer_y = false;  ///< for counts: ticks at integers only

  /// Leaves room for ticks and titles within `rect`: the y title is above its axis, the x title
  /// below the right end of its axis.
  static PlotFrame within(const ScreenRect& rect, Interval x_range, Interval y_range);
  /// Draws grid lines, ticks, and titles. `ctx` is in the element's pixels.
  void draw(NVGcontext* ctx, const std::string& x_title, const std::string& y_title) const;
};

/// A plot, or a message if there is nothing to plot. Part "plot": the area between the axes.
class Plot : public Element {
 public:
  using Element::Element;

 protected:
  virtual PlotFrame frame() const = 0;
  virtual std::string message() const = 0;  ///< empty if there are data
  virtual std::string x_title() const = 0;
  virtual std::string y_title() const = 0;
  virtual std::string remark() const { return ""; }  ///< above the plot, at the right
  virtual void paint_data(NVGcontext* ctx, const PlotFrame& frame) = 0;

  std::vector<Part> parts() const override { return {{"plot", frame().area}}; }
  void paint(NVGcontext* ctx) override;
};

}  // namespace slalom
