// SPDX-License-Identifier: BSD-3-Clause
#include "derived_speeds.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// Velocities in the world frame, m/s and rad/s.
struct WorldVelocity {
  double x, y, w;
};

WorldVelocity mean_velocity(const Sample& from, const Sample& to) {
  const double dt = to.t - from.t;
  return {(to.pose.x - from.pose.x) / dt, (to.pose.y - from.pose.y) / dt,
          mrpt::math::wrapToPi(to.pose.phi - from.pose.phi) / dt};
}

WorldVelocity mix(const WorldVelocity& a, const WorldVelocity& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y), a.w + fraction * (b.w - a.w)};
}

/// The derivative at sample i of the parabola through it and the nearest two.
WorldVelocity velocity_at(const std::vector<Sample>& samples, std::size_t i) {
  if (samples.size() == 2) return mean_velocity(samples[0], samples[1]);
  const std::size_t middle = std::clamp<std::size_t>(i, 1, samples.size() - 2);
  const Sample &a = samples[middle - 1], &b = samples[middle], &c = samples[middle + 1];
  // Mean velocities apply at the midpoints of their intervals; linear between and beyond them.
  const double first = 0.5 * (a.t + b.t), second = 0.5 * (b.t + c.t);
  const double fraction = (samples[i].t - first) / (second - first);
  return mix(mean_velocity(a, b), mean_velocity(b, c), fraction);
}

}  // namespace

void derive_speeds(Trajectory& trajectory, const MissingSpeeds& missing) {
  if (!missing.v && !missing.w && !missing.vy) return;
  auto& samples = trajectory.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const WorldVelocity velocity = velocity_at(samples, i);
    const double c = math::cos(samples[i].pose.phi), s = math::sin(samples[i].pose.phi);
    if (missing.v) samples[i].v = c * velocity.x + s * velocity.y;
    if (missing.vy) samples[i].vy = -s * velocity.x + c * velocity.y;
    if (missing.w) samples[i].w = velocity.w;
  }
}

void derive_headings(Trajectory& trajectory) {
  constexpr double kNoise = 1e-3;  // m
  auto& samples = trajectory.samples;
  double heading = 0;
  for (std::size_t begin = 0, end = 1; begin < samples.size(); ++end) {
    const auto& from = samples[begin].pose;
    if (end < samples.size()) {
      const auto& to = samples[end].pose;
      if (distance_between(to, from) <= kNoise) continue;
      heading = math::atan2(to.y - from.y, to.x - from.x);
    }
    for (; begin < end; ++begin) samples[begin].pose.phi = heading;
  }
}

}  // namespace slalom
