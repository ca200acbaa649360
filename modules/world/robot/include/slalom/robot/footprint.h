// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The outline of a robot in its own frame (m, x ahead, y left): a disc around the center, or a
/// simple polygon, convex or not, that contains the center.
class Footprint {
 public:
  static Footprint disc(double radius);

  /// "x,y; x,y; ...", three or more corners in either order, with the center (0, 0) strictly
  /// inside. Throws std::invalid_argument whose text is what was expected.
  static Footprint parse(const std::string& text);
  /// The same; throws Error (Usage) at the option or key `where`.
  static Footprint parse(const std::string& text, const std::string& where);

  bool is_disc() const { return corners_.empty(); }
  double inscribed_radius() const { return inscribed_; }  ///< m, around the center
  double enclosing_radius() const { return enclosing_; }  ///< m, around the center
  /// m, the farthest point to the left or right of the center: what a passage needs to each side
  /// of a robot that drives straight through.
  double half_width() const;
  /// Counter-clockwise, robot frame; empty for a disc.
  const std::vector<mrpt::math::TPoint2D>& corners() const { return corners_; }
  /// The convex hull, which methods are given; the corners themselves if they are convex.
  const std::vector<mrpt::math::TPoint2D>& hull() const { return hull_; }
  /// The corners in the world frame for the robot at `pose`.
  std::vector<mrpt::math::TPoint2D> corners_at(const mrpt::math::TPose2D& pose) const;

 private:
  std::vector<mrpt::math::TPoint2D> corners_, hull_;
  double inscribed_ = 0, enclosing_ = 0;
};

/// The corners of the convex hull of points, counter-clockwise.
std::vector<mrpt::math::TPoint2D> convex_hull(const std::vector<mrpt::math::TPoint2D>& points);

/// m, of a disc that passes wherever the robot does: half the width of a polygon that rotates in
/// place and drives straight through, or the radius of a robot that is none.
double passing_radius(double radius, const std::optional<Footprint>& turning_polygon);

}  // namespace slalom
