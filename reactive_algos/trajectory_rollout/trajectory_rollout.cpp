// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_rollout/trajectory_rollout.h"

#include <slalom/core/math.h>

namespace trajectory_rollout {

using namespace reactive;

namespace {

constexpr double kTimeStep = 0.05;  // s, of simulated trajectories
/// m ahead of a trajectory's end, where its distance to the goal is evaluated to include its
/// heading.
constexpr double kHeadingLookAhead = 0.3;

double distance_to_path(const Point& p, const std::vector<Point>& path) {
  Point nearest = p;
  double squared = HUGE_VAL;
  for (const Point& q : path) {
    const double dx = p.x - q.x, dy = p.y - q.y;
    if (dx * dx + dy * dy >= squared) continue;
    squared = dx * dx + dy * dy;
    nearest = q;
  }
  return distance(p, nearest);
}

/// The distance from `p` to the closest mover after `time` s, m.
double distance_to_movers(const std::vector<Track>& movers, const Point& p, double time) {
  double result = HUGE_VAL;
  for (const Track& mover : movers)
    result =
        std::min(result, slalom::math::hypot(mover.position.x + time * mover.velocity.x - p.x,
                                             mover.position.y + time * mover.velocity.y - p.y) -
                             mover.radius);
  return result;
}

/// footprint_clearance() with respect to movers.
double clearance_to_movers(const std::vector<Track>& movers, const Pose& pose, double time,
                           const Robot& robot) {
  if (movers.empty()) return HUGE_VAL;
  const Transform frame(pose);
  double result = HUGE_VAL;
  for (const FootprintDisc& disc : robot.discs)
    result = std::min(result,
                      distance_to_movers(movers, frame.to_world(disc.center), time) + disc.inset);
  return result;
}

/// All rollouts at the same time. v depends on the row, w and the heading on the column.
class Simulation {
 public:
  Simulation(const Pose& pose, const Twist& now, const VelocityGrid& desired)
      : desired_(desired),
        v_(desired.v.size(), now.v),
        w_(desired.w.size(), now.w),
        headings_(desired.w.size(), pose.phi),
        turns_(desired.w.size()) {
    poses_.assign(size(), pose);
  }

  std::size_t size() const { return v_.size() * w_.size(); }
  const PoseBatch& poses() const { return poses_; }
  Pose pose(std::size_t i) const { return {poses_.x[i], poses_.y[i], headings_[i % w_.size()]}; }
  void advance(const Robot& robot);

 private:
  const VelocityGrid& desired_;
  std::vector<double> v_, w_, headings_;
  std::vector<Turn> turns_;  ///< of columns, in the last time step
  PoseBatch poses_;
};

void Simulation::advance(const Robot& robot) {
  for (std::size_t k = 0; k < w_.size(); ++k) {
    const double next =
        apply_acceleration_limits({0, w_[k]}, {0, desired_.w[k]}, robot, kTimeStep).w;
    turns_[k] = turn_from(headings_[k], 0.5 * (w_[k] + next), kTimeStep);
    headings_[k] = turns_[k].phi;
    w_[k] = next;
  }
  if (!robot.is_disc())
    for (std::size_t i = 0; i < size(); ++i) {
      poses_.cosine[i] = slalom::math::cos(headings_[i % w_.size()]);
      poses_.sine[i] = slalom::math::sin(headings_[i % w_.size()]);
    }
  std::size_t i = 0;
  for (std::size_t row = 0; row < v_.size(); ++row) {
    const double next =
        apply_acceleration_limits({v_[row], 0}, {desired_.v[row], 0}, robot, kTimeStep).v;
    const double length = 0.5 * (v_[row] + next) * kTimeStep;
    v_[row] = next;
    for (const Turn& turn : turns_) {
      const double chord = length * turn.sinc;
      poses_.x[i] += chord * turn.cosine;
      poses_.y[i] += chord * turn.sine;
      ++i;
    }
  }
}

}  // namespace

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("alpha", alpha, "-", "weight of Obs, the lack of clearance", Range::at_least(0));
  v.option("beta", beta, "-", "weight of Gdist, the remaining distance to the goal",
           Range::at_least(0));
  v.option("gamma", gamma, "-", "weight of Pdist, the distance from the path", Range::at_least(0));
  v.option("delta", delta, "m^3/s^2", "weight of 1 / v^2", Range::at_least(0));
  v.option("margin", margin, "m", "added to the robot's radius in collision checks",
           Range::between(0, 10));
  v.option("comfort", comfort, "m", "clearance of the footprint beyond which there is no cost",
           Range::between(0, 10));
  v.option("horizon", horizon, "s", "simulated time", Range::between(0.1, 30));
  v.option("v_samples", v_samples, "-", "linear velocities", Range::between(2, 1000));
  v.option("w_samples", w_samples, "-", "angular velocities", Range::between(3, 1000));
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this bearing of the path the robot rotates in place", Range::between(0.1, M_PI));
  v.option("memory", memory, "m", "half the side length of the local map", Range::between(1, 50));
  v.option("look_ahead", look_ahead, "m", "length of the path that Pdist is measured from",
           Range::between(0.1, 50));
}

// Ratios of the weights decide: beta is left out.
std::vector<slalom_range> tuning_ranges() {
  return {
      {"alpha", 0.1, 10, 1, 0},    {"gamma", 0.04, 4, 1, 0},        {"delta", 0.0003, 0.03, 1, 0},
      {"margin", 0, 0.15, 0, 0},   {"comfort", 0.1, 1, 1, 0},       {"horizon", 0.7, 3, 1, 0},
      {"w_samples", 13, 41, 0, 1}, {"turn_in_place", 0.5, 3, 0, 0}, {"look_ahead", 0.5, 4, 1, 0}};
}

std::vector<Rollout> roll_out(const ClearanceMap& map, const Pose& pose, const Twist& now,
                              const VelocityGrid& desired, const Robot& robot, double radius,
                              double horizon, const std::vector<Track>& movers) {
  Simulation simulation(pose, now, desired);
  std::vector<Rollout> result(simulation.size(),
                              {pose, footprint_clearance(map, pose, robot), horizon, false, false});
  std::vector<double> clearances(padded(result.size()));
  for (double t = 0; t < horizon; t += kTimeStep) {
    simulation.advance(robot);
    footprint_clearances(map, simulation.poses(), result.size(), robot, clearances.data());
    for (std::size_t i = 0; i < result.size(); ++i) {
      Rollout& rollout = result[i];
      if (rollout.collides) continue;
      const double to_mover = clearance_to_movers(movers, simulation.pose(i), t + kTimeStep, robot);
      const double clearance = std::min(clearances[i], to_mover);
      rollout.clearance = std::min(rollout.clearance, clearance);
      if (clearance >= radius) continue;
      rollout.collides = true;
      rollout.meets_mover = to_mover < clearances[i];
      rollout.until_contact = t;
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) result[i].end = simulation.pose(i);
  return result;
}

TrajectoryRollout::TrajectoryRollout(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(with_cover_discs(robot)),
      map_({parameters.memory, clearance_band(robot_, parameters.margin, parameters.comfort)},
           robot_),
      local_planner_(robot_, parameters.margin, parameters.comfort,
                     std::max(robot.max_v * parameters.horizon + kHeadingLookAhead,
                              CostToGo::kPathReach * parameters.look_ahead)),
      turn_(parameters.turn_in_place) {}

void TrajectoryRollout::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
}

void TrajectoryRollout::take_over(TrajectoryRollout& before) {
  task_ = before.task_;
  map_.take_over(before.map_);
  turn_.take_over(before.turn_);
}

double TrajectoryRollout::cost(const Rollout& rollout, const Twist& desired,
                               const Waypoint& target) {
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
  VelocityGrid desired;
  const int rows = parameters_.v_samples;
  const int columns = parameters_.w_samples;
  for (int i = 0; i < rows; ++i) desired.v.push_back(top_speed * i / (rows - 1));
  for (int k = 0; k < columns; ++k)
    desired.w.push_back(robot_.max_w * (-1 + 2.0 * k / (columns - 1)));
  const double radius =
      clearance_radius(map_.clearance(), observation.pose, robot_, parameters_.margin);
  const std::vector<Rollout> rollouts =
      roll_out(map_.clearance(), observation.pose, observation.measured, desired, robot_, radius,
               parameters_.horizon, movers(observation.pose));
  Twist best{0, 0};
  double best_cost = HUGE_VAL, latest_contact = -1;
  for (std::size_t i = 0; i < rollouts.size(); ++i) {
    const Twist twist = {desired.v[i / desired.w.size()], desired.w[i % desired.w.size()]};
    // If all trajectories collide, it evades a mover on the one with the latest contact, brakes on
    // the arc that it is on, or turns.
    if (rollouts[i].collides) {
      if (best_cost < HUGE_VAL || rollouts[i].until_contact <= latest_contact) continue;
      latest_contact = rollouts[i].until_contact;
      best = rollouts[i].meets_mover
                 ? twist
                 : brake_on_arc(observation.measured, robot_, task_.control_period)
                       .value_or(Twist{0, twist.w});
      continue;
    }
    const double value = cost(rollouts[i], twist, target);
    if (value >= best_cost) continue;
    best_cost = value;
    best = twist;
  }
  return best;
}

/// Rays that end at movers say nothing: the map is that of the static obstacles.
Observation TrajectoryRollout::without_movers(Observation observation) const {
  constexpr double kTolerance = 0.15;  // m
  const std::size_t rays = observation.ranges.size();
  for (std::size_t i = 0; i < rays; ++i) {
    const double angle = ray_angle(i, rays, robot_.aperture), range = observation.ranges[i];
    const Point end{range * slalom::math::cos(angle), range * slalom::math::sin(angle)};
    if (distance_to_movers(tracks_, end, 0) < kTolerance) observation.ranges[i] = -1;
  }
  return observation;
}

std::vector<Track> TrajectoryRollout::movers(const Pose& pose) const {
  std::vector<Track> movers = tracks_;
  for (Track& mover : movers) {
    mover.position = to_world(pose, mover.position);
    mover.velocity = to_world({0, 0, pose.phi}, mover.velocity);
  }
  return movers;
}

/// Whether a mover meets the robot if it stays where it is.
bool TrajectoryRollout::is_met_standing() const {
  for (double t = 0; t < parameters_.horizon; t += kTimeStep)
    if (clearance_to_movers(tracks_, {}, t, robot_) < robot_.radius + parameters_.margin)
      return true;
  return false;
}

Twist TrajectoryRollout::step(const Observation& observation) {
  if (tracks_.empty())
    map_.update(observation);
  else
    map_.update(without_movers(observation));
  const Point goal = to_world(observation.pose, observation.goal);
  // Near the goal the point ahead must not lie beyond it: the robot would stop too early.
  heading_look_ahead_ = std::min(kHeadingLookAhead,
                                 0.5 * slalom::math::hypot(observation.goal.x, observation.goal.y));
  const Waypoint target = local_planner_.find(map_, observation.pose, goal, parameters_.look_ahead);
  path_.clear();
  if (target.reachable && !target.is_goal)
    path_ = local_planner_.cost_to_go().path({observation.pose.x, observation.pose.y},
                                             parameters_.look_ahead);
  const Point seen = to_robot(observation.pose, target.position);
  const double bearing = slalom::math::atan2(seen.y, seen.x);
  if (turn_.update(bearing, map_.clearance(), observation.pose, robot_, parameters_.margin) &&
      !is_met_standing())
    return clamp_to_limits(turn_.twist(bearing, observation.measured, robot_, task_.control_period),
                           robot_);
  const double goal_distance = slalom::math::hypot(observation.goal.x, observation.goal.y);
  const double top =
      std::min(robot_.max_v, stopping_speed(goal_distance + 0.5 * task_.goal_tolerance, robot_));
  return clamp_to_limits(best(observation, target, top), robot_);
}

}  // namespace trajectory_rollout
