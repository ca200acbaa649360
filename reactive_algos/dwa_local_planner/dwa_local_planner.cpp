// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/dwa_local_planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dwa_local_planner {

using namespace reactive;

namespace {

constexpr double kGlobalHalfSize = 15;  // m, of the global costmap without a known map

/// Replaces limits of 0 by those of the robot, and reduces others to these.
Parameters limited(Parameters p, const Robot& robot) {
  const auto limit = [](double& value, double most) {
    value = value == 0 ? most : std::min(value, most);
  };
  limit(p.max_vel_x, robot.max_v);
  limit(p.max_vel_theta, robot.max_w);
  limit(p.acc_lim_x, robot.max_accel_v);
  limit(p.acc_lim_theta, robot.max_accel_w);
  if (p.min_vel_trans > p.max_vel_x)
    throw std::invalid_argument("min_vel_trans exceeds the largest speed");
  p.min_vel_x = std::clamp(p.min_vel_x, robot.forward_only ? 0 : -robot.max_v, p.max_vel_x);
  p.backup_speed = std::min(p.backup_speed, robot.max_v);
  return p;
}

Robot with_obstacle_range(Robot robot, double range) {
  robot.max_range = std::min(robot.max_range, range);
  return robot;
}

Inflation inflation_of(const Parameters& p, const Footprint& footprint) {
  return {footprint.inscribed_radius(), p.inflation_radius, p.cost_scaling_factor};
}

}  // namespace

DwaLocalPlanner::DwaLocalPlanner(const Parameters& parameters, const Robot& robot)
    : parameters_(limited(parameters, robot)),
      robot_(with_obstacle_range(robot, parameters.obstacle_range)),
      memory_(kGlobalHalfSize, parameters.resolution),
      scorer_(parameters_, robot),
      local_map_(0.5 * parameters.width, parameters.resolution,
                 inflation_of(parameters, scorer_.footprint()),
                 scorer_.footprint().circumscribed_radius() + parameters.inflation_radius +
                     2 * parameters.resolution),
      global_map_(kGlobalHalfSize, parameters.resolution,
                  inflation_of(parameters, scorer_.footprint())),
      oscillation_(parameters.oscillation_reset_dist, parameters.oscillation_reset_angle,
                   parameters.min_vel_trans),
      recovery_(parameters_, robot, scorer_.footprint()) {}

void DwaLocalPlanner::set_goal_tolerance() {
  const double own = parameters_.xy_goal_tolerance;
  if (own > task_.goal_tolerance)
    throw std::invalid_argument("xy_goal_tolerance exceeds the tolerance of the task");
  goal_tolerance_ = own > 0 ? own : 0.5 * task_.goal_tolerance;
}

void DwaLocalPlanner::reset(const NavigationTask& task) {
  task_ = task;
  set_goal_tolerance();
  memory_.clear();
  oscillation_.reset();
  recovery_.reset();
  path_.clear();
  since_plan_ = HUGE_VAL;
  waiting_ = {};
  progress_from_ = {HUGE_VAL, HUGE_VAL};
}

void DwaLocalPlanner::take_over(DwaLocalPlanner& before) {
  task_ = before.task_;
  memory_ = std::move(before.memory_);
  global_map_.take_over(before.global_map_);
  oscillation_.take_over(before.oscillation_);
  recovery_.take_over(before.recovery_);
  path_ = std::move(before.path_);
  since_plan_ = before.since_plan_;
  waiting_ = before.waiting_;
  progress_from_ = before.progress_from_;
  set_goal_tolerance();
}

/// Whether there is a path; if there is none, the one before is kept.
bool DwaLocalPlanner::plan(const Pose& pose) {
  const Point position{pose.x, pose.y};
  global_map_.build(position, memory_.points());
  std::vector<Point> path = planner_.plan(global_map_.costs(), position, task_.goal);
  if (path.empty()) return false;
  path_ = std::move(path);
  waiting_.plan = since_plan_ = 0;
  return true;
}

/// The part of the path from the robot to the border of the local costmap.
std::vector<Point> DwaLocalPlanner::local_path(const Pose& pose) {
  const Point position{pose.x, pose.y};
  const auto nearest =
      std::min_element(path_.begin(), path_.end(), [&](const Point& a, const Point& b) {
        return distance(a, position) < distance(b, position);
      });
  path_.erase(path_.begin(), nearest);
  const double reach = 0.5 * parameters_.width - 3 * parameters_.resolution;
  const auto leaves = std::find_if(path_.begin(), path_.end(), [&](const Point& p) {
    return std::max(std::abs(p.x - pose.x), std::abs(p.y - pose.y)) > reach;
  });
  return {path_.begin(), leaves};
}

/// Sets the velocities of the trajectory with the lowest cost; false if there is none.
bool DwaLocalPlanner::follow_path(const Observation& observation, Twist& best) {
  const std::vector<Point> path = local_path(observation.pose);
  if (path.empty()) return false;
  scorer_.prepare(local_map_, observation.pose, path);
  double lowest = HUGE_VAL;
  for (const Twist& twist :
       velocity_samples(parameters_, observation.measured, task_.control_period)) {
    if (!oscillation_.allows(twist)) continue;
    const double cost = scorer_.cost(twist, lowest);
    if (cost < 0 || cost >= lowest) continue;
    lowest = cost;
    best = twist;
  }
  if (lowest == HUGE_VAL) return false;
  oscillation_.commanded(best, observation.pose);
  return true;
}

void DwaLocalPlanner::count_time(const Pose& pose) {
  for (double* time : {&waiting_.plan, &waiting_.control, &waiting_.progress, &since_plan_})
    *time += task_.control_period;
  if (distance({pose.x, pose.y}, progress_from_) <= parameters_.oscillation_distance) return;
  progress_from_ = {pose.x, pose.y};
  waiting_.progress = 0;
}

/// Whether a recovery behavior must begin.
bool DwaLocalPlanner::is_stuck() const {
  const Parameters& p = parameters_;
  const bool oscillates = p.oscillation_timeout > 0 && waiting_.progress > p.oscillation_timeout;
  return oscillates || waiting_.plan > p.planner_patience ||
         waiting_.control > p.controller_patience;
}

Twist DwaLocalPlanner::step(const Observation& observation) {
  const Pose& pose = observation.pose;
  memory_.clear_along(pose, observation.ranges, robot_, parameters_.raytrace_range);
  memory_.update(pose, observation.ranges, robot_);
  local_map_.build({pose.x, pose.y}, memory_.points());
  if (distance({pose.x, pose.y}, task_.goal) <= goal_tolerance_) return {};
  count_time(pose);
  if (const auto command = recovery_.step(local_map_, pose)) return *command;
  const double period = 1 / parameters_.planner_frequency;  // infinite for 0
  if (path_.empty() || since_plan_ > period - 0.5 * task_.control_period) plan(pose);
  Twist best;
  const bool moves = !path_.empty() && follow_path(observation, best);
  if (moves) {
    waiting_.control = 0;
    // While there are trajectories along a path, no other is needed.
    waiting_.plan = 0;
  } else {
    plan(pose);
  }
  if (is_stuck()) {
    recovery_.start(pose, memory_);
    waiting_.plan = waiting_.progress = 0;
    return {};
  }
  if (moves && waiting_.progress == 0) recovery_.succeeded();
  return moves ? best : Twist{};
}

}  // namespace dwa_local_planner
