#include "trajectory_rollout/trajectory_rollout.h"

namespace trajectory_rollout {

using namespace reactive;

namespace {

constexpr double kTimeStep = 0.05;  // s, of simulated trajectories
/// m ahead of a trajectory's end, where its distance to the goal is evaluated to include its
/// heading.
constexpr double kHeadingLookAhead = 0.3;

double distance_to_path(const Point& p, const std::vector<Point>& path) {
  double nearest = HUGE_VAL;
  for (const Point& q : path) nearest = std::min(nearest, distance(p, q));
  return path.empty() ? 0 : nearest;
}

}  // namespace

const TrajectoryRollout::Settings& TrajectoryRollout::settings() {
  static constexpr Settings kSettings = {
      {{"alpha", "1.0", "-", "weight of Obs, the lack of clearance"}, &Parameters::alpha},
      {{"beta", "1.0", "-", "weight of Gdist, the remaining distance to the goal"},
       &Parameters::beta},
      {{"gamma", "0.4", "-", "weight of Pdist, the distance from the path"}, &Parameters::gamma},
      {{"delta", "0.003", "m^3/s^2", "weight of 1 / v^2"}, &Parameters::delta},
      {{"margin", "0.04", "m", "added to the robot's radius in collision checks"},
       &Parameters::margin,
       0,
       10},
      {{"comfort", "0.3", "m", "clearance of the footprint beyond which there is no cost"},
       &Parameters::comfort,
       0,
       10},
      {{"horizon", "1.5", "s", "simulated time"}, &Parameters::horizon, 0.1, 30},
      {{"v_samples", "8", "-", "linear velocities"}, &Parameters::v_samples, 2, 1000},
      {{"w_samples", "25", "-", "angular velocities"}, &Parameters::w_samples, 3, 1000},
      {{"turn_in_place", "1.3", "rad",
        "beyond this bearing of the path the robot rotates in place"},
       &Parameters::turn_in_place,
       0.1,
       M_PI},
      {{"memory", "6", "m", "half the side length of the local map"}, &Parameters::memory, 1, 50},
      {{"look_ahead", "1.5", "m", "length of the path that Pdist is measured from"},
       &Parameters::look_ahead,
       0.1,
       50}};
  return kSettings;
}

Rollout roll_out(const ClearanceMap& map, const Pose& pose, const Twist& now, const Twist& desired,
                 const Robot& robot, double radius, double horizon) {
  Rollout result{pose, map.at({pose.x, pose.y}), horizon, false};
  Twist twist = now;
  for (double t = 0; t < horizon; t += kTimeStep) {
    const Twist next = apply_acceleration_limits(twist, desired, robot, kTimeStep);
    result.end =
        integrate(result.end, {0.5 * (twist.v + next.v), 0.5 * (twist.w + next.w)}, kTimeStep);
    twist = next;
    const double here = map.at({result.end.x, result.end.y});
    result.clearance = std::min(result.clearance, here);
    if (here >= radius) continue;
    result.collides = true;
    result.until_contact = t;
    return result;
  }
  return result;
}

TrajectoryRollout::TrajectoryRollout(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(robot),
      map_({parameters.memory, 0.05, robot.radius + std::max(0.8, parameters.comfort)}, robot),
      local_planner_(
          {robot.radius + parameters.margin + 0.01, robot.radius + parameters.comfort, 2.0},
          robot.radius + 0.01),
      turn_(parameters.turn_in_place, 0.4) {}

void TrajectoryRollout::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

double TrajectoryRollout::cost(const Rollout& rollout, const Twist& desired,
                               const Waypoint& target) const {
  const double gap = rollout.clearance - robot_.radius;
  const double deficit = std::clamp(1 - gap / std::max(1e-3, parameters_.comfort), 0.0, 1.0);
  const Point end{rollout.end.x, rollout.end.y};
  const Point ahead = to_world(rollout.end, {heading_look_ahead_, 0});
  double remaining_distance = distance(ahead, target.position);
  if (target.reachable && !target.is_goal) {
    remaining_distance = local_planner_.cost_to_go().at(ahead);
    // The point ahead is inside an obstacle: use the end itself, with a penalty.
    if (remaining_distance >= CostToGo::kUnreached)
      remaining_distance = local_planner_.cost_to_go().at(end) + heading_look_ahead_;
  }
  const double v = std::max(0.05, desired.v);
  return parameters_.alpha * deficit * deficit + parameters_.beta * remaining_distance +
         parameters_.gamma * distance_to_path(end, path_) + parameters_.delta / (v * v);
}

Twist TrajectoryRollout::best(const Observation& observation, const Waypoint& target,
                              double top_speed) {
  const auto rows = static_cast<int>(parameters_.v_samples);
  const auto columns = static_cast<int>(parameters_.w_samples);
  const Twist& now = observation.measured;
  const double radius =
      clearance_radius(map_.clearance(), observation.pose, robot_, parameters_.margin);
  Twist best{0, 0};
  double best_cost = HUGE_VAL, latest_contact = -1;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      const Twist desired = {top_speed * i / (rows - 1),
                             robot_.max_w * (-1 + 2.0 * k / (columns - 1))};
      const Rollout rollout = roll_out(map_.clearance(), observation.pose, now, desired, robot_,
                                       radius, parameters_.horizon);
      // If all trajectories collide, brake on the one with the latest contact.
      if (rollout.collides && best_cost < HUGE_VAL) continue;
      if (rollout.collides) {
        if (rollout.until_contact <= latest_contact) continue;
        latest_contact = rollout.until_contact;
        best = {0, desired.w};
        continue;
      }
      const double value = cost(rollout, desired, target);
      if (value >= best_cost) continue;
      best_cost = value;
      best = desired;
    }
  return best;
}

Twist TrajectoryRollout::step(const Observation& observation) {
  map_.update(observation);
  const Point goal = to_world(observation.pose, observation.goal);
  // Near the goal the point ahead must not lie beyond it: the robot would stop too early.
  heading_look_ahead_ =
      std::min(kHeadingLookAhead, 0.5 * std::hypot(observation.goal.x, observation.goal.y));
  const Waypoint target = local_planner_.find(map_, observation.pose, goal, parameters_.look_ahead);
  path_.clear();
  if (target.reachable && !target.is_goal)
    path_ = local_planner_.cost_to_go().path({observation.pose.x, observation.pose.y},
                                             parameters_.look_ahead);
  const Point seen = to_robot(observation.pose, target.position);
  const double bearing = std::atan2(seen.y, seen.x);
  if (turn_.update(bearing)) return clamp_to_limits(turn_.twist(bearing, robot_), robot_);
  const double goal_distance = std::hypot(observation.goal.x, observation.goal.y);
  const double top =
      std::min(robot_.max_v, stopping_speed(goal_distance + 0.5 * task_.goal_tolerance, robot_));
  return clamp_to_limits(best(observation, target, top), robot_);
}

}  // namespace trajectory_rollout
