// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/trajectory/standing.h>

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace slalom {

bool has_stood(const Trajectory& trajectory, double now, const mrpt::math::TPose2D& pose,
               bool is_disc) {
  constexpr double kTimeTolerance = 1e-9;  // s, times are sums and multiples of steps
  constexpr double kMovement = 1e-6;       // m, rad: rounding errors
  const auto& samples = trajectory.samples;
  const double since = now - kStandingTime + kTimeTolerance;
  if (samples.empty() || samples.front().t > since) return false;
  // Back to the last sample before that time.
  for (std::size_t i = samples.size(); i > 0; --i) {
    const Sample& sample = samples[i - 1];
    const double turn = is_disc ? 0 : std::abs(mrpt::math::wrapToPi(sample.pose.phi - pose.phi));
    if (distance_between(sample.pose, pose) > kMovement || turn > kMovement) return false;
    if (sample.t <= since) break;
  }
  return true;
}

}  // namespace slalom
