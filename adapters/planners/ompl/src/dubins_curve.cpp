// SPDX-License-Identifier: BSD-3-Clause
#include "dubins_curve.h"

#include <slalom/core/math.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

/// In [0, 2 pi); 0 for rounding errors below 0.
double positive_angle(double angle) {
  constexpr double kRounding = 1e-9;
  const double wrapped = angle - 2 * M_PI * std::floor(angle / (2 * M_PI));
  return 2 * M_PI - wrapped < kRounding ? 0 : wrapped;
}

}  // namespace

/// The six words with the formulas of Shkel and Lumelsky, "Classification of the Dubins set"
/// (2001): a and b are the headings relative to the line from pose to pose, d is its length.
DubinsCurve::DubinsCurve(const TPose2D& from, const TPose2D& to, double radius)
    : from_(from), radius_(radius) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double d = math::hypot(dx, dy) / radius, line = math::atan2(dy, dx);
  const double a = positive_angle(from.phi - line), b = positive_angle(to.phi - line);
  const double sa = math::sin(a), sb = math::sin(b), ca = math::cos(a), cb = math::cos(b);
  const double cab = math::cos(a - b);
  const auto offer = [&](std::array<int, 3> turns, double t, double p, double q) {
    const std::array<double, 3> parts = {positive_angle(t), p, positive_angle(q)};
    if (parts[0] + parts[1] + parts[2] >= parts_[0] + parts_[1] + parts_[2]) return;
    turns_ = turns;
    parts_ = parts;
  };
  {  // The circles lie on the same side, left and right: the line is parallel to their centers.
    const double left = math::atan2(cb - ca, d + sa - sb);
    offer({1, 0, 1}, left - a, math::hypot(cb - ca, d + sa - sb), b - left);
    const double right = math::atan2(ca - cb, d - sa + sb);
    offer({-1, 0, -1}, a - right, math::hypot(ca - cb, d - sa + sb), right - b);
  }
  if (const double square = d * d - 2 + 2 * cab + 2 * d * (sa + sb); square >= 0) {
    const double p = std::sqrt(square);
    const double heading = math::atan2(-ca - cb, d + sa + sb) - math::atan2(-2, p);
    offer({1, 0, -1}, heading - a, p, heading - b);
  }
  if (const double square = d * d - 2 + 2 * cab - 2 * d * (sa + sb); square >= 0) {
    const double p = std::sqrt(square);
    const double heading = math::atan2(ca + cb, d - sa - sb) - math::atan2(2, p);
    offer({-1, 0, 1}, a - heading, p, b - heading);
  }
  if (const double c = 0.125 * (6 - d * d + 2 * cab + 2 * d * (sa - sb)); std::abs(c) <= 1) {
    const double p = 2 * M_PI - math::acos(c);
    const double t = positive_angle(a - math::atan2(ca - cb, d - sa + sb) + 0.5 * p);
    offer({-1, 1, -1}, t, p, a - b - t + p);
  }
  if (const double c = 0.125 * (6 - d * d + 2 * cab - 2 * d * (sa - sb)); std::abs(c) <= 1) {
    const double p = 2 * M_PI - math::acos(c);
    const double t = positive_angle(math::atan2(cb - ca, d + sa - sb) - a + 0.5 * p);
    offer({1, -1, 1}, t, p, b - a - t + p);
  }
}

TPose2D DubinsCurve::at(double fraction) const {
  double left = std::clamp(fraction, 0.0, 1.0) * (parts_[0] + parts_[1] + parts_[2]);
  TPose2D pose = from_;
  for (std::size_t i = 0; i < 3 && left > 0; ++i) {
    const double part = std::min(left, parts_[i]);
    left -= part;
    if (turns_[i] == 0) {
      pose.x += radius_ * part * math::cos(pose.phi);
      pose.y += radius_ * part * math::sin(pose.phi);
    } else {
      const double heading = pose.phi + turns_[i] * part;
      pose.x += turns_[i] * radius_ * (math::sin(heading) - math::sin(pose.phi));
      pose.y -= turns_[i] * radius_ * (math::cos(heading) - math::cos(pose.phi));
      pose.phi = heading;
    }
  }
  pose.phi = mrpt::math::wrapToPi(pose.phi);
  return pose;
}

}  // namespace slalom
