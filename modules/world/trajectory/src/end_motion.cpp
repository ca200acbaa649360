// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/trajectory/end_motion.h>

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace slalom {
namespace {

EndMotion motion_without_contact(const std::vector<Sample>& samples, double radius) {
  double driven = 0, turned = 0;
  for (std::size_t i = samples.size() - 1; i > 0; --i) {
    const mrpt::math::TPose2D &a = samples[i - 1].pose, &b = samples[i].pose;
    if (samples[i - 1].t < samples.back().t - kEndWindow - 1e-9) break;
    driven += math::hypot(b.x - a.x, b.y - a.y);
    turned += std::abs(mrpt::math::wrapToPi(b.phi - a.phi));
  }
  if (driven >= radius) return EndMotion::Driving;
  return turned < M_PI / 2 ? EndMotion::Stopped : EndMotion::Turning;
}

}  // namespace

EndMotion end_motion(Outcome outcome, const Trajectory& trajectory, double radius, double max_v) {
  const std::vector<Sample>& samples = trajectory.samples;
  if (outcome == Outcome::Stuck || outcome == Outcome::Timeout)
    return motion_without_contact(samples, radius);
  const double speed = math::hypot(samples.back().v, samples.back().vy);
  return speed > max_v / 2 ? EndMotion::Fast : EndMotion::Slow;
}

}  // namespace slalom
