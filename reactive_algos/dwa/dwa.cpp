// SPDX-License-Identifier: BSD-3-Clause
#include "dwa/dwa.h"

#include <slalom/core/math.h>

namespace dwa {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("alpha", alpha, "-", "weight of the heading, Eq. (13)", Range::at_least(0));
  v.option("beta", beta, "-", "weight of the free distance", Range::at_least(0));
  v.option("gamma", gamma, "-", "weight of the velocity", Range::at_least(0));
  v.option("margin", margin, "m", "added to the robot's radius", Range::between(0, 10));
  v.option("horizon", horizon, "m", "free distance at which the term saturates",
           Range::between(0.1, 100));
  v.option("v_samples", v_samples, "-", "linear velocities in the window", Range::between(2, 1000));
  v.option("w_samples", w_samples, "-", "angular velocities in the window",
           Range::between(3, 1000));
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this bearing of the path the robot rotates in place", Range::between(0.1, M_PI));
  v.option("memory", memory, "m", "half the side length of the local map", Range::between(1, 50));
  v.option("guidance", guidance,
           "along a navigation function of the local map instead of to the goal");
  v.option("look_ahead", look_ahead, "m", "with guidance: look-ahead distance along the path",
           Range::between(0.1, 50));
}

Window dynamic_window(const Twist& now, const Robot& robot, double period) {
  const Twist lowest = apply_acceleration_limits(now, {0, -robot.max_w}, robot, period);
  const Twist highest = apply_acceleration_limits(now, {robot.max_v, robot.max_w}, robot, period);
  return {clamp_to_limits(lowest, robot), clamp_to_limits(highest, robot)};
}

bool can_stop(const Twist& twist, double free_distance, const Robot& robot, double period) {
  // The command holds for a period before the robot can brake.
  const double braking_distance = free_distance - twist.v * period;
  if (twist.v > stopping_speed(braking_distance, robot)) return false;
  const double turn = twist.v > 0 ? std::abs(twist.w) * braking_distance / twist.v : HUGE_VAL;
  return std::abs(twist.w) * std::abs(twist.w) <=
             2 * kBrakingFraction * robot.max_accel_w * std::max(0.0, turn) ||
         twist.w == 0;
}

double heading_term(const Pose& pose, const Twist& twist, const Point& target, const Robot& robot,
                    double period) {
  Pose then = integrate(pose, twist, period);
  then.phi += 0.5 * twist.w * std::abs(twist.w) / robot.max_accel_w;
  const Point seen = to_robot(then, target);
  return 1 - std::abs(slalom::math::atan2(seen.y, seen.x)) / M_PI;
}

Dwa::Dwa(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(with_cover_discs(robot)),
      map_({parameters.memory, 0.8 + robot_.radius}, robot_),
      local_planner_({robot_.radius + parameters.margin, 2 * robot_.radius + parameters.margin},
                     robot_.radius + kCheckMargin, CostToGo::kPathReach * parameters.look_ahead),
      turn_(parameters.turn_in_place, 0.5) {}

void Dwa::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

void Dwa::take_over(Dwa& before) {
  task_ = before.task_;
  map_.take_over(before.map_);
  turn_.take_over(before.turn_);
}

Waypoint Dwa::target(const Observation& observation) {
  const Point goal = to_world(observation.pose, observation.goal);
  if (!parameters_.guidance) return {goal, true, true};
  return local_planner_.find(map_, observation.pose, goal, parameters_.look_ahead);
}

void Dwa::evaluate(const Observation& observation, const Point& target, double top_speed) {
  const int rows = parameters_.v_samples;
  const int columns = parameters_.w_samples;
  const Window window = dynamic_window(observation.measured, robot_, task_.control_period);
  const double top = std::max(window.low.v, std::min(window.high.v, top_speed));
  const double radius =
      clearance_radius(map_.clearance(), observation.pose, robot_, parameters_.margin);
  std::vector<Twist> twists;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k)
      twists.push_back({window.low.v + (top - window.low.v) * i / (rows - 1),
                        window.low.w + (window.high.w - window.low.w) * k / (columns - 1)});
  const std::vector<double> free_distances = free_arc_lengths(
      map_.clearance(), observation.pose, twists, robot_, radius, parameters_.horizon);
  candidates_.clear();
  for (std::size_t i = 0; i < twists.size(); ++i) {
    Candidate c;
    c.twist = twists[i];
    c.admissible = can_stop(c.twist, free_distances[i], robot_, task_.control_period) &&
                   (c.twist.v > 0 || can_rotate(map_.clearance(), observation.pose, robot_, radius,
                                                c.twist.w, task_.control_period));
    c.clearance = free_distances[i] / parameters_.horizon;
    c.velocity = c.twist.v / robot_.max_v;
    c.heading = heading_term(observation.pose, c.twist, target, robot_, task_.control_period);
    candidates_.push_back(c);
  }
}

/// Eq. (13), smoothed over adjacent velocities in the window: inadmissible neighbors lower the
/// value, so that the robot keeps a distance from obstacles.
double Dwa::smoothed(std::size_t v, std::size_t w) const {
  const auto columns = static_cast<std::size_t>(parameters_.w_samples);
  const auto rows = candidates_.size() / columns;
  double sum = 0, weight = 0;
  for (std::size_t i = v > 0 ? v - 1 : v; i <= std::min(v + 1, rows - 1); ++i)
    for (std::size_t k = w > 0 ? w - 1 : w; k <= std::min(w + 1, columns - 1); ++k) {
      const Candidate& c = candidates_[i * columns + k];
      const double cell_weight = i == v && k == w ? 2 : 1;
      weight += cell_weight;
      if (c.admissible)
        sum += cell_weight * (parameters_.alpha * c.heading + parameters_.beta * c.clearance +
                              parameters_.gamma * c.velocity);
    }
  return sum / weight;
}

/// If none is admissible, the robot brakes on the arc of the last command, which was.
Twist Dwa::best(const Twist& measured) const {
  const auto columns = static_cast<std::size_t>(parameters_.w_samples);
  Twist best = brake_on_arc(measured, robot_, task_.control_period).value_or(Twist{0, 0});
  double best_value = -1;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (!candidates_[i].admissible) continue;
    const double value = smoothed(i / columns, i % columns);
    if (value <= best_value) continue;
    best_value = value;
    best = candidates_[i].twist;
  }
  return best;
}

Twist Dwa::step(const Observation& observation) {
  map_.update(observation);
  const Waypoint waypoint = target(observation);
  const Point seen = to_robot(observation.pose, waypoint.position);
  const double bearing = slalom::math::atan2(seen.y, seen.x);
  if (turn_.update(bearing, map_.clearance(), observation.pose, robot_, parameters_.margin))
    return clamp_to_limits(turn_.twist(bearing, observation.measured, robot_, task_.control_period),
                           robot_);
  const double goal_distance = slalom::math::hypot(observation.goal.x, observation.goal.y);
  evaluate(observation, waypoint.position,
           stopping_speed(goal_distance + 0.5 * task_.goal_tolerance, robot_));
  return clamp_to_limits(best(observation.measured), robot_);
}

}  // namespace dwa
