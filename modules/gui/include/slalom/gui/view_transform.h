#pragma once

#include <slalom/scenario/geometry.h>

#include <mrpt/math/TPoint2D.h>

namespace slalom {

/// How the world (m, y up) lies on a rectangle of the screen (pixels, y down).
class ViewTransform {
 public:
  ViewTransform() = default;
  /// `center` (m) is shown in the middle of a rectangle at (left, top) of this size (pixels).
  ViewTransform(mrpt::math::TPoint2D center, double pixels_per_metre, double left, double top,
                double width, double height);
  /// Shows all of `bounds`, with a margin (pixels) on each side.
  static ViewTransform fitting(const Bounds& bounds, double left, double top, double width,
                               double height, double margin = 16);

  mrpt::math::TPoint2D to_screen(const mrpt::math::TPoint2D& world) const;
  mrpt::math::TPoint2D to_world(const mrpt::math::TPoint2D& screen) const;
  double pixels_per_metre() const { return scale_; }
  Bounds visible() const;  ///< the part of the world that is seen (m)

  /// The same part of the world as well as it goes, on another rectangle.
  ViewTransform on(double left, double top, double width, double height) const;
  /// Moved by so many pixels.
  ViewTransform panned(double dx, double dy) const;
  /// Larger by `factor` about a point of the screen, which stays where it is. Stays between
  /// kLeastScale and kLargestScale.
  ViewTransform zoomed(const mrpt::math::TPoint2D& about, double factor) const;

  static constexpr double kLeastScale = 0.01;     ///< pixels per m
  static constexpr double kLargestScale = 20000;  ///< pixels per m

 private:
  mrpt::math::TPoint2D center_ = {0, 0};
  double scale_ = 1;
  double left_ = 0, top_ = 0, width_ = 1, height_ = 1;
};

}  // namespace slalom
