// SPDX-License-Identifier: BSD-3-Clause
#include "termination_checker.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/core/text.h>
#include <slalom/scenario/touched_mover.h>
#include <slalom/trajectory/standing.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Tolerance (s) for rounding errors of times, which are sums and multiples of steps.
constexpr double kTimeTolerance = 1e-9;

}  // namespace

bool is_at_goal(const Scenario& scenario, const SimulationOptions& options, const TPose2D& pose) {
  const TPoint2D& goal = scenario.goal();
  // Almost always: faster than a distance, with an allowance for its rounding.
  if (std::abs(pose.x - goal.x) > 1.001 * options.goal_tolerance) return false;
  if (distance_between(pose, goal) > options.goal_tolerance) return false;
  const std::optional<double>& heading = scenario.goal_heading();
  return !heading ||
         std::abs(std::remainder(pose.phi - *heading, 2 * M_PI)) <= options.goal_heading_tolerance;
}

bool TerminationChecker::find_contact(TimedMotion& motion, double& fraction) {
  const bool is_static = contact_->find_contact(motion.from, motion.to, fraction);
  if (is_static) motion.end = motion.begin + fraction * (motion.end - motion.begin);
  double before = 1;
  if (mover_contact_.find_contact(motion, before) == nullptr) return is_static;
  motion.to = interpolate(motion.from, motion.to, before);
  motion.end = motion.begin + before * (motion.end - motion.begin);
  fraction *= before;
  return true;
}

bool TerminationChecker::reached_goal(const TPose2D& pose) const {
  return is_at_goal(world_.scenario(), options_, pose);
}

bool TerminationChecker::left_workspace(const TPose2D& pose) const {
  return !world_.scenario().bounds().contains(TPoint2D(pose));
}

bool TerminationChecker::is_in_time(double now) const {
  return now <= options_.time_limit() + kTimeTolerance;
}

bool TerminationChecker::is_time_over(double now) const {
  return now >= options_.time_limit() - kTimeTolerance;
}

std::string TerminationChecker::describe_contact(const Trajectory& trajectory,
                                                 const std::string& where) const {
  const Sample& last = trajectory.samples.back();
  const Mover* mover =
      touched_mover(world_, movers_.movers(), TPoint2D(last.pose), footprint_.enclosing_radius(),
                    footprint_.corners_at(last.pose), trajectory.duration());
  if (mover == nullptr) return "contact " + where;
  const double speed = math::hypot(last.v, last.vy);
  const bool is_person = movers_.is_person(*mover);
  return std::string("contact with ") + (is_person ? "person" : "moving obstacle") + " '" +
         mover->id + "' " + where +
         (has_stood(trajectory, last.t, last.pose, footprint_.is_disc())
              ? ", the robot had stood for " + format_number(kStandingTime) + " s"
              : ", the robot at " + format_fixed(speed, 2) + " m/s") +
         (is_person && movers_.notices(*mover) ? ", to blame: the robot, which was noticed" : "");
}

bool TerminationChecker::is_stuck(const Trajectory& trajectory, double now,
                                  const TPose2D& pose) const {
  const auto& samples = trajectory.samples;
  if (samples.empty() || now - samples.front().t < stuck_time_ - kTimeTolerance) return false;
  const double since = now - stuck_time_ - kTimeTolerance;
  for (std::size_t i = samples.size(); i > 0 && samples[i - 1].t >= since; --i)
    if (distance_between(samples[i - 1].pose, pose) > options_.stuck_distance) return false;
  return true;
}

}  // namespace slalom
