#pragma once

#include "widgets/element.h"

#include <slalom/scenario/geometry.h>

#include <mrpt/math/TPoint2D.h>

#include <string>

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

}  // namespace slalom
