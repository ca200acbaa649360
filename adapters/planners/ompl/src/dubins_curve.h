// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose2D.h>

#include <array>

namespace slalom {

/// The shortest curve of bounded curvature from pose to pose, forward only: three arcs of the
/// turning radius, the second one possibly a straight line (Dubins 1957). Ends at the second pose
/// to 1e-8 of its length; OMPL's DubinsStateSpace aborts by assertions where poses are aligned
/// except for rounding errors.
class DubinsCurve {
 public:
  DubinsCurve(const mrpt::math::TPose2D& from, const mrpt::math::TPose2D& to, double radius);

  double length() const { return radius_ * (parts_[0] + parts_[1] + parts_[2]); }  ///< m
  mrpt::math::TPose2D at(double fraction) const;

 private:
  mrpt::math::TPose2D from_;
  double radius_;
  std::array<int, 3> turns_ = {0, 0, 0};         ///< 1 left, 0 straight, -1 right
  std::array<double, 3> parts_ = {1e300, 0, 0};  ///< lengths in units of the radius
};

}  // namespace slalom
