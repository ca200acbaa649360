// SPDX-License-Identifier: BSD-3-Clause
#include "regulated_pure_pursuit/regulated_pure_pursuit.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace regulated_pure_pursuit {

using namespace reactive;

namespace {

/// Drops the cells before the farthest one that a disc of `radius` reaches in a straight line:
/// cells follow each other in eight directions only.
std::vector<Point> straightened(const ClearanceMap& map, const Point& from, std::vector<Point> path,
                                double radius) {
  const auto blocked = std::find_if(path.begin(), path.end(), [&](const Point& p) {
    return !line_is_free(map, from, p, radius);
  });
  if (blocked != path.begin()) path.erase(path.begin(), blocked - 1);
  return path;
}

}  // namespace

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("desired_linear_vel", desired_linear_vel, "m/s", "speed, at most that of the robot",
           Range::at_least(0));
  v.option("lookahead_time", lookahead_time, "s", "look-ahead distance per speed",
           Range::between(0, 30));
  v.option("min_lookahead_dist", min_lookahead_dist, "m", "minimum look-ahead distance",
           Range::between(0.05, 20));
  v.option("max_lookahead_dist", max_lookahead_dist, "m", "maximum look-ahead distance",
           Range::between(0.05, 20));
  v.option("regulated_linear_scaling_min_radius", regulated_linear_scaling_min_radius, "m",
           "the robot is slower in turns of a smaller radius", Range::at_least(0));
  v.option("regulated_linear_scaling_min_speed", regulated_linear_scaling_min_speed, "m/s",
           "minimum speed of both regulations", Range::at_least(0));
  v.option("cost_scaling_dist", cost_scaling_dist, "m",
           "the robot is slower at a smaller clearance", Range::at_least(0));
  v.option("cost_scaling_gain", cost_scaling_gain, "-",
           "factor of the speed at a smaller clearance", Range::at_least(0));
  v.option("approach_velocity_scaling_dist", approach_velocity_scaling_dist, "m",
           "the robot is slower this close to the goal", Range::at_least(0));
  v.option("min_approach_linear_velocity", min_approach_linear_velocity, "m/s",
           "minimum speed close to the goal", Range::at_least(0));
  v.option("max_allowed_time_to_collision_up_to_carrot", max_allowed_time_to_collision_up_to_carrot,
           "s", "the robot stops if it would collide within it", Range::at_least(0));
  v.option("rotate_to_heading_min_angle", rotate_to_heading_min_angle, "rad",
           "beyond this bearing of the path the robot rotates in place", Range::between(0.1, M_PI));
  v.option("margin", margin, "m", "added to the robot's radius in collision checks",
           Range::between(0, 10));
  v.option("comfort", comfort, "m",
           "clearance of the footprint beyond which a path does not cost more",
           Range::between(0, 10));
  v.option("memory", memory, "m", "half the side length of the local map", Range::between(1, 50));
}

Point carrot_of(const std::vector<Point>& path, double distance) {
  Point inside;
  for (const Point& p : path) {
    if (slalom::math::hypot(p.x, p.y) <= distance) {
      inside = p;
      continue;
    }
    // The fraction t of the segment with |inside + t * step| = distance.
    const Point step{p.x - inside.x, p.y - inside.y};
    const double a = step.x * step.x + step.y * step.y;
    const double b = inside.x * step.x + inside.y * step.y;
    const double c = inside.x * inside.x + inside.y * inside.y - distance * distance;
    const double t = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
    return {inside.x + t * step.x, inside.y + t * step.y};
  }
  return inside;
}

double curvature_to(const Point& carrot) {
  const double squared = carrot.x * carrot.x + carrot.y * carrot.y;
  return squared > 0 ? 2 * carrot.y / squared : 0;
}

double regulated_speed(const Parameters& parameters, double inscribed_radius, double curvature,
                       double clearance, double goal_distance) {
  const double desired = parameters.desired_linear_vel;
  double speed = desired;
  const double min_radius = parameters.regulated_linear_scaling_min_radius;
  if (std::abs(curvature) * min_radius > 1)
    speed = std::min(speed, desired / (std::abs(curvature) * min_radius));
  if (clearance < parameters.cost_scaling_dist)
    speed =
        std::min(speed, desired * parameters.cost_scaling_gain * (clearance + inscribed_radius) /
                            (parameters.cost_scaling_dist + inscribed_radius));
  speed = std::max(speed, std::min(desired, parameters.regulated_linear_scaling_min_speed));
  if (goal_distance >= parameters.approach_velocity_scaling_dist) return speed;
  const double approach = speed * goal_distance / parameters.approach_velocity_scaling_dist;
  return std::min(speed, std::max(approach, parameters.min_approach_linear_velocity));
}

RegulatedPurePursuit::RegulatedPurePursuit(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(with_cover_discs(robot)),
      map_({parameters.memory,
            clearance_band(robot_, parameters.margin,
                           std::max(parameters.comfort, parameters.cost_scaling_dist))},
           robot_),
      local_planner_(robot_, parameters.margin, parameters.comfort,
                     CostToGo::kPathReach * parameters.memory),
      turn_(parameters.rotate_to_heading_min_angle, 0.3 * parameters.rotate_to_heading_min_angle) {
  parameters_.max_lookahead_dist =
      std::max(parameters.min_lookahead_dist, parameters.max_lookahead_dist);
  parameters_.desired_linear_vel = std::min(parameters.desired_linear_vel, robot.max_v);
}

void RegulatedPurePursuit::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

void RegulatedPurePursuit::take_over(RegulatedPurePursuit& before) {
  task_ = before.task_;
  map_.take_over(before.map_);
  turn_.take_over(before.turn_);
}

/// The path to `goal` in the frame of the pose, without its start; the goal if no path is known.
std::vector<Point> RegulatedPurePursuit::path(const Pose& pose, const Point& goal) {
  const ClearanceMap& map = map_.clearance();
  const Point position{pose.x, pose.y};
  const double radius =
      clearance_radius(map, pose, robot_, std::max(parameters_.margin, parameters_.comfort));
  if (line_is_free(map, position, goal, radius)) return {goal};
  const Waypoint waypoint = local_planner_.find(map_, pose, goal, parameters_.memory);
  std::vector<Point> path;
  if (waypoint.reachable && !waypoint.is_goal)
    path = straightened(map, position,
                        local_planner_.cost_to_go().path(position, parameters_.memory), radius);
  if (path.empty()) path = {waypoint.position};
  return path;
}

/// In the robot frame.
Point RegulatedPurePursuit::carrot(const Observation& observation) {
  const double look_ahead =
      std::clamp(std::abs(observation.measured.v) * parameters_.lookahead_time,
                 parameters_.min_lookahead_dist, parameters_.max_lookahead_dist);
  std::vector<Point> path =
      this->path(observation.pose, to_world(observation.pose, observation.goal));
  for (Point& p : path) p = to_robot(observation.pose, p);
  return carrot_of(path, look_ahead);
}

bool RegulatedPurePursuit::is_collision_imminent(const Pose& pose, const Twist& twist,
                                                 double radius, double carrot_distance) const {
  const double length =
      std::min(twist.v * parameters_.max_allowed_time_to_collision_up_to_carrot, carrot_distance);
  return free_arc_lengths(map_.clearance(), pose, {twist}, robot_, radius, length).front() < length;
}

Twist RegulatedPurePursuit::step(const Observation& observation) {
  map_.update(observation);
  const ClearanceMap& map = map_.clearance();
  const Point carrot = this->carrot(observation);
  const double bearing = slalom::math::atan2(carrot.y, carrot.x);
  const bool turns = turn_.update(bearing, map, observation.pose, robot_, parameters_.margin);
  const Twist rotation = turn_.twist(bearing, observation.measured, robot_, task_.control_period);
  if (turns) return clamp_to_limits(rotation, robot_);
  const double curvature = curvature_to(carrot);
  const double clearance = footprint_clearance(map, observation.pose, robot_) - robot_.radius;
  double v = regulated_speed(parameters_, inscribed_radius(robot_), curvature, clearance,
                             slalom::math::hypot(observation.goal.x, observation.goal.y));
  // A robot that cannot turn faster would leave the arc.
  if (std::abs(v * curvature) > robot_.max_w) v = robot_.max_w / std::abs(curvature);
  const Twist twist{v, v * curvature};
  const double radius = clearance_radius(map, observation.pose, robot_, parameters_.margin);
  if (!is_collision_imminent(observation.pose, twist, radius,
                             slalom::math::hypot(carrot.x, carrot.y)))
    return clamp_to_limits(twist, robot_);
  // The robot turns to the path: it would stay there, as it lacks the recovery behavior of another
  // node.
  if (can_rotate(map, observation.pose, robot_, radius, rotation.w, task_.control_period))
    return clamp_to_limits(rotation, robot_);
  return {};
}

}  // namespace regulated_pure_pursuit
