#include "judge.h"

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Times (s) are sums and multiples of steps; this much absorbs their rounding.
constexpr double kTimeTolerance = 1e-9;

TPoint2D position(const TPose2D& pose) {
  return {pose.x, pose.y};
}

double distance(const TPoint2D& a, const TPoint2D& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

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
