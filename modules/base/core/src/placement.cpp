// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/placement.h>

namespace slalom {

using mrpt::math::TPoint3D;

Placement::Placement(double x, double y, double z, double yaw, double pitch, double roll)
    : at_(x, y, z) {
  const auto [sy, cy] = math::sin_cos(yaw);
  const auto [sp, cp] = math::sin_cos(pitch);
  const auto [sr, cr] = math::sin_cos(roll);
  axes_[0] = {cy * cp, sy * cp, -sp};
  axes_[1] = {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr};
  axes_[2] = {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr};
}

Placement Placement::of_quaternion(const TPoint3D& at, double qx, double qy, double qz, double qw) {
  Placement placement;
  placement.at_ = at;
  placement.axes_[0] = {1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + qw * qz),
                        2 * (qx * qz - qw * qy)};
  placement.axes_[1] = {2 * (qx * qy - qw * qz), 1 - 2 * (qx * qx + qz * qz),
                        2 * (qy * qz + qw * qx)};
  placement.axes_[2] = {2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx),
                        1 - 2 * (qx * qx + qy * qy)};
  return placement;
}

double Placement::yaw() const {
  return math::atan2(axes_[0].y, axes_[0].x);
}

TPoint3D Placement::turned(const TPoint3D& v) const {
  return {axes_[0].x * v.x + axes_[1].x * v.y + axes_[2].x * v.z,
          axes_[0].y * v.x + axes_[1].y * v.y + axes_[2].y * v.z,
          axes_[0].z * v.x + axes_[1].z * v.y + axes_[2].z * v.z};
}

Placement Placement::operator+(const Placement& local) const {
  Placement sum;
  sum.at_ = point(local.at_);
  for (std::size_t i = 0; i < axes_.size(); ++i) sum.axes_[i] = turned(local.axes_[i]);
  return sum;
}

Placement Placement::inverse() const {
  Placement result;
  result.axes_ = {{{axes_[0].x, axes_[1].x, axes_[2].x},
                   {axes_[0].y, axes_[1].y, axes_[2].y},
                   {axes_[0].z, axes_[1].z, axes_[2].z}}};
  result.at_ = result.turned({-at_.x, -at_.y, -at_.z});
  return result;
}

}  // namespace slalom
