// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>

#include <array>

namespace slalom {

/// A pose in three dimensions, m and rad, with the same bits on all machines: those of CPose3D
/// depend on MRPT's package.
class Placement {
 public:
  Placement() = default;
  Placement(double x, double y, double z, double yaw, double pitch, double roll);
  /// The pose with the rotation of a unit quaternion.
  static Placement of_quaternion(const mrpt::math::TPoint3D& at, double qx, double qy, double qz,
                                 double qw);

  double x() const { return at_.x; }
  double y() const { return at_.y; }
  double z() const { return at_.z; }
  double yaw() const;
  double cosine_of_tilt() const { return axes_[2].z; }

  /// The vector with these coordinates along the axes.
  mrpt::math::TPoint3D turned(const mrpt::math::TPoint3D& v) const;
  /// The point with these coordinates in the frame of the pose.
  mrpt::math::TPoint3D point(const mrpt::math::TPoint3D& p) const { return at_ + turned(p); }
  /// The pose that is `local` in the frame of this one.
  Placement operator+(const Placement& local) const;
  /// The pose of the origin in the frame of this one.
  Placement inverse() const;

 private:
  mrpt::math::TPoint3D at_ = {0, 0, 0};
  std::array<mrpt::math::TPoint3D, 3> axes_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

}  // namespace slalom
