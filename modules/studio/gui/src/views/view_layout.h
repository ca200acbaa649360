// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/scenario/geometry.h>

#include <mrpt/math/TPoint2D.h>

#include <string>
#include <vector>

namespace slalom {

/// Maps the world (m, y up) to a rectangle of the screen (pixels, y down).
class ViewTransform {
 public:
  ViewTransform() = default;
  /// `center` (m) is mapped to the center of `screen` (pixels).
  ViewTransform(mrpt::math::TPoint2D center, double pixels_per_meter, const ScreenRect& screen);
  /// Shows all of `bounds`, with a margin (pixels) on each side.
  static ViewTransform fitting(const Bounds& bounds, const ScreenRect& screen, double margin = 16);

  mrpt::math::TPoint2D to_screen(const mrpt::math::TPoint2D& world) const;
  mrpt::math::TPoint2D to_world(const mrpt::math::TPoint2D& screen) const;
  double pixels_per_meter() const { return scale_; }
  Bounds visible() const;  ///< the visible part of the world (m)

  /// Shows the same part of the world on another rectangle, as far as its aspect ratio allows.
  ViewTransform on(const ScreenRect& screen) const;
  /// Moved by (dx, dy) pixels.
  ViewTransform panned(double dx, double dy) const;
  /// Scaled by `factor` about a point of the screen. The scale is clamped to kMinScale, kMaxScale.
  ViewTransform zoomed(const mrpt::math::TPoint2D& about, double factor) const;

  static constexpr double kMinScale = 0.01;   ///< pixels per m
  static constexpr double kMaxScale = 20000;  ///< pixels per m

 private:
  mrpt::math::TPoint2D center_ = {0, 0};
  double scale_ = 1;
  ScreenRect screen_ = {0, 0, 1, 1};
};

/// A bar of a round length that shows the scale of the view.
struct ScaleBar {
  double meters = 0;
  double pixels = 0;

  /// The longest bar of 1, 2 or 5 times a power of ten (m) that has at most `max_pixels`.
  static ScaleBar choose(double pixels_per_meter, double max_pixels);
  std::string text() const;  ///< "20 cm", "5 m", "2 km"
};

/// Layout of the scenario view: tools at the top, a status line at the bottom, between them the
/// canvas with the legend over its upper right corner. Independent of the window; in pixels.
struct ViewLayout {
  struct Button {
    std::string name, title;
  };

  static constexpr double kLegendWidth = 250;

  /// `layers` are the rows of the legend, empty when it is closed; all of them are placed, in
  /// columns where the canvas is low. `legend_width` is what a column needs, as far as there is
  /// space. Buttons that do not fit in a row are wrapped.
  ViewLayout(double width, double height, const std::vector<Button>& buttons,
             const std::vector<std::string>& layers, double legend_width = kLegendWidth);
  /// The part of the canvas to which a scenario is fitted: without the legend if there is enough
  /// space.
  ScreenRect open_canvas() const;
  /// The part at a position; null for none.
  const Element::Part* at(double x, double y) const;
  const Element::Part* find(const std::string& name) const;

  ScreenRect canvas;     ///< of the scenario
  ScreenRect status;     ///< the status line
  ScreenRect scale_bar;  ///< at the end of the status line
  ScreenRect tools;      ///< background of the buttons
  ScreenRect legend;     ///< background of its title and rows
  /// "tool disc", "zoom in", "zoom out", "fit", "legend", "layer voronoi"
  std::vector<Element::Part> parts;

 private:
  double place_buttons(double width, const std::vector<Button>& buttons);
  void place_legend(const std::vector<std::string>& layers, double preferred_width);
};

}  // namespace slalom
