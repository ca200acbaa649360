#include "trajectory_rollout/trajectory_rollout.h"

namespace trajectory_rollout {

using namespace reactive;

namespace {

constexpr double kTimeStep = 0.05;  // s, of simulated trajectories
/// m ahead of its end from which a trajectory's way to the goal is measured: so its heading counts.
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
      {{"beta", "1.0", "-", "weight of Gdist, the way left to the goal"}, &Parameters::beta},
      {{"gamma", "0.4", "-", "weight of Pdist, the distance from the path"}, &Parameters::gamma},
      {{"delta", "0.003", "m^3/s^2", "weight of 1 / v^2"}, &Parameters::delta},
      {{"margin", "0.04", "m", "added to the robot's radius: nearer is a collision"},
       &Parameters::margin,
       0,
       10},
      {{"comfort", "0.3", "m", "clearance of the footprint that costs nothing"},
       &Parameters::comfort,
       0,
       10},
      {{"horizon", "1.5", "s", "simulated"}, &Parameters::horizon, 0.1, 30},
      {{"v_samples", "8", "-", "speeds"}, &Parameters::v_samples, 2, 1000},
      {{"w_samples", "25", "-", "turning speeds"}, &Parameters::w_samples, 3, 1000},
      {{"turn_in_place", "1.3", "rad", "a way farther aside is turned to without driving"},
       &Parameters::turn_in_place,
       0.1,
       kPi},
      {{"memory", "6", "m", "half the side of the local map"}, &Parameters::memory, 1, 50},
      {{"look_ahead", "1.5", "m", "length of the path that Pdist is measured from"},
       &Parameters::look_ahead,
       0.1,
       50}};
  return kSettings;
}

Rollout roll_out(const ClearanceMap& map, const Pose& pose, const Speeds& now, const Speeds& wanted,
                 const Robot& robot, double radius, double horizon) {
  Rollout result{pose, map.at({pose.x, pose.y}), horizon, false};
  Speeds speeds = now;
  for (double t = 0; t < horizon; t += kTimeStep) {
    const Speeds next = approached(speeds, wanted, robot, kTimeStep);
    result.end =
        moved(result.end, {0.5 * (speeds.v + next.v), 0.5 * (speeds.w + next.w)}, kTimeStep);
    speeds = next;
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
      guide_({robot.radius + parameters.margin + 0.01, robot.radius + parameters.comfort, 2.0},
             robot.radius + 0.01),
      turn_(parameters.turn_in_place, 0.4) {}

void TrajectoryRollout::reset(const Task& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

double TrajectoryRollout::cost(const Rollout& rollout, const Speeds& wanted,
                               const Waypoint& target) const {
  const double room = rollout.clearance - robot_.radius;
  const double lack = std::clamp(1 - room / std::max(1e-3, parameters_.comfort), 0.0, 1.0);
  const Point end{rollout.end.x, rollout.end.y};
  const Point ahead = to_world(rollout.end, {look_, 0});
  double left = distance(ahead, target.position);
  if (target.reachable && !target.is_goal) {
    left = guide_.cost_to_go().at(ahead);
    // A point ahead that lies within something says nothing: the end itself, and the price of that.
    if (left >= CostToGo::kUnreached) left = guide_.cost_to_go().at(end) + look_;
  }
  const double v = std::max(0.05, wanted.v);
  return parameters_.alpha * lack * lack + parameters_.beta * left +
         parameters_.gamma * distance_to_path(end, path_) + parameters_.delta / (v * v);
}

Speeds TrajectoryRollout::best(const Observation& observation, const Waypoint& target,
                               double top_speed) {
  const auto rows = static_cast<int>(parameters_.v_samples);
  const auto columns = static_cast<int>(parameters_.w_samples);
  const Speeds& now = observation.measured;
  const double radius =
      radius_to_keep(map_.clearance(), observation.pose, robot_, parameters_.margin);
  Speeds best{0, 0};
  double best_cost = HUGE_VAL, longest = -1;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      const Speeds wanted = {top_speed * i / (rows - 1),
                             robot_.max_w * (-1 + 2.0 * k / (columns - 1))};
      const Rollout rollout = roll_out(map_.clearance(), observation.pose, now, wanted, robot_,
                                       radius, parameters_.horizon);
      // When all touch something, brake on the way that does so last.
      if (rollout.collides && best_cost < HUGE_VAL) continue;
      if (rollout.collides) {
        if (rollout.until_contact <= longest) continue;
        longest = rollout.until_contact;
        best = {0, wanted.w};
        continue;
      }
      const double value = cost(rollout, wanted, target);
      if (value >= best_cost) continue;
      best_cost = value;
      best = wanted;
    }
  return best;
}

Speeds TrajectoryRollout::step(const Observation& observation) {
  map_.update(observation);
  const Point goal = to_world(observation.pose, observation.goal);
  // Near the goal the point ahead must not pass it: the robot would stop that much before.
  look_ = std::min(kHeadingLookAhead, 0.5 * std::hypot(observation.goal.x, observation.goal.y));
  const Waypoint target = guide_.find(map_, observation.pose, goal, parameters_.look_ahead);
  path_.clear();
  if (target.reachable && !target.is_goal)
    path_ =
        guide_.cost_to_go().path({observation.pose.x, observation.pose.y}, parameters_.look_ahead);
  const Point seen = to_robot(observation.pose, target.position);
  const double bearing = std::atan2(seen.y, seen.x);
  if (turn_.wanted(bearing)) return limited(turn_.speeds(bearing, robot_), robot_);
  const double left = std::hypot(observation.goal.x, observation.goal.y);
  const double top =
      std::min(robot_.max_v, stopping_speed(left + 0.5 * task_.goal_tolerance, robot_));
  return limited(best(observation, target, top), robot_);
}

}  // namespace trajectory_rollout
