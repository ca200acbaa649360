#include "judge.h"

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Touching exactly is free, as it is for reference paths; this much (m) absorbs rounding.
constexpr double kContactTolerance = 1e-9;
/// Times (s) are sums and multiples of steps; this much absorbs their rounding.
constexpr double kTimeTolerance = 1e-9;

TPoint2D position(const TPose2D& pose) {
  return {pose.x, pose.y};
}

double distance(const TPoint2D& a, const TPoint2D& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

bool Judge::touches(const TPose2D& pose) const {
  return is_blocked(position(pose), position(pose));
}

bool Judge::is_blocked(const TPoint2D& a, const TPoint2D& b) const {
  return world_.distance_field().segment_clearance(a, b, radius_) < radius_ - kContactTolerance;
}

bool Judge::meets_obstacle(const TPose2D& from, TPose2D& to, double& share) {
  const TPoint2D a = position(from), b = position(to);
  free_travel_ -= distance(a, b);
  if (free_travel_ > 0) return false;
  if (!is_blocked(a, b)) {
    free_travel_ = world_.distance_field().clearance(b) - radius_;
    return false;
  }
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (is_blocked(a, a + (b - a) * middle) ? high : low) = middle;
  }
  share = high;
  const TPoint2D contact = a + (b - a) * high;
  const double turned = mrpt::math::wrapToPi(to.phi - from.phi);
  to = {contact.x, contact.y, mrpt::math::wrapToPi(from.phi + high * turned)};
  return true;
}

bool Judge::reached_goal(const TPose2D& pose) const {
  return distance(position(pose), world_.scenario().goal()) <= options_.goal_tolerance;
}

bool Judge::left_workspace(const TPose2D& pose) const {
  return !world_.scenario().bounds().contains(position(pose));
}

bool Judge::is_in_time(double now) const {
  return now <= options_.max_time + kTimeTolerance;
}

bool Judge::is_time_over(double now) const {
  return now >= options_.max_time - kTimeTolerance;
}

bool Judge::is_stuck(const Trajectory& trajectory, double now, const TPose2D& pose) const {
  const auto& samples = trajectory.samples;
  if (samples.empty() || now - samples.front().t < options_.stuck_time - kTimeTolerance)
    return false;
  const double since = now - options_.stuck_time - kTimeTolerance;
  for (std::size_t i = samples.size(); i > 0 && samples[i - 1].t >= since; --i)
    if (distance(position(samples[i - 1].pose), position(pose)) > options_.stuck_distance)
      return false;
  return true;
}

}  // namespace slalom
