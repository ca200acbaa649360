// SPDX-License-Identifier: BSD-3-Clause
#include "dwa_local_planner/trajectory_scorer.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace dwa_local_planner {

using namespace reactive;

namespace {

constexpr double kIllegal = -1;

/// How long a velocity is kept: the robot can stop before the end.
double simulated_time(const Parameters& p, double v) {
  return std::max(p.sim_time, std::abs(v) / p.acc_lim_x + p.stop_time_buffer);
}

/// m from the robot, where distances are read.
double reach(const Parameters& p) {
  const double v = std::max(p.max_vel_x, -p.min_vel_x);
  return v * simulated_time(p, v) + p.forward_point_distance + 2 * p.resolution;
}

}  // namespace

std::vector<double> evenly_spaced(double low, double high, int count) {
  if (low >= high) return {low};
  std::vector<double> values;
  const double step = (high - low) / (count - 1);
  for (int i = 0; i < count; ++i) {
    const double value = i + 1 < count ? low + i * step : high;
    if (!values.empty() && values.back() < 0 && value > 0) values.push_back(0);
    values.push_back(value);
  }
  return values;
}

std::vector<Twist> velocity_samples(const Parameters& p, const Twist& measured, double period) {
  const auto window = [&](double value, double accel, double low, double high, double count) {
    const double from = std::clamp(value - accel * period, low, high);
    const double to = std::clamp(value + accel * period, low, high);
    return evenly_spaced(from, to, static_cast<int>(count));
  };
  std::vector<Twist> samples;
  const auto angular =
      window(measured.w, p.acc_lim_theta, -p.max_vel_theta, p.max_vel_theta, p.vth_samples);
  for (const double v : window(measured.v, p.acc_lim_x, p.min_vel_x, p.max_vel_x, p.vx_samples))
    for (const double w : angular)
      if (std::abs(v) >= p.min_vel_trans - 1e-4 || std::abs(w) >= p.min_vel_theta - 1e-4)
        samples.push_back({v, w});
  return samples;
}

TrajectoryScorer::TrajectoryScorer(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      footprint_(robot, parameters.footprint_padding),
      path_(reach(parameters)),
      goal_(reach(parameters)),
      goal_front_(reach(parameters)) {}

void TrajectoryScorer::prepare(const Costmap& map, const Pose& pose,
                               const std::vector<Point>& path) {
  constexpr double kEverywhere = 100;  // m
  map_ = &map;
  pose_ = pose;
  const Point position{pose.x, pose.y}, goal = path.back();
  const double inscribed = map.inflation().inscribed_radius;
  const PathCosts lengths = {std::nextafter(inscribed, HUGE_VAL), inscribed, 0};
  const double ahead = parameters_.forward_point_distance;
  const double angle = slalom::math::atan2(goal.y - pose.y, goal.x - pose.x);
  const Point front{goal.x + ahead * slalom::math::cos(angle),
                    goal.y + ahead * slalom::math::sin(angle)};
  path_.compute(map.clearance(), path, position, lengths, kEverywhere);
  goal_.compute(map.clearance(), goal, position, lengths, kEverywhere);
  goal_front_.compute(map.clearance(), front, position, lengths, kEverywhere);
  aligns_ = distance(position, goal) > ahead;
}

/// The highest cost along the trajectory, and its end.
double TrajectoryScorer::obstacle_cost(const Twist& twist, double limit, Pose& end) const {
  const Parameters& p = parameters_;
  const double time = simulated_time(p, twist.v);
  const double length = std::abs(twist.v) * time, turn = std::abs(twist.w) * time;
  const int steps = static_cast<int>(
      std::ceil(std::max(length / p.sim_granularity, turn / p.angular_sim_granularity)));
  const double step_turn = steps > 0 ? twist.w * time / steps : 0;
  // A step is a chord of the arc between two turns of half the angle.
  const auto half_turn = slalom::math::sin_cos(0.5 * step_turn);
  const double half_cosine = half_turn.cos, half_sine = half_turn.sin;
  const double sinc = std::abs(step_turn) < 1e-6 ? 1 : half_sine / (0.5 * step_turn);
  const double chord = steps > 0 ? twist.v * time / steps * sinc : 0;
  const double excess = std::max(0.0, std::abs(twist.v) - p.scaling_speed) /
                        std::max(1e-3, p.max_vel_x - p.scaling_speed);
  const Footprint footprint =
      excess > 0 ? footprint_.scaled(1 + p.max_scaling_factor * excess) : footprint_;
  const auto heading = slalom::math::sin_cos(pose_.phi);
  double c = heading.cos, s = heading.sin;
  const auto turn_half = [&] {
    const double turned = c * half_cosine - s * half_sine;
    s = s * half_cosine + c * half_sine;
    c = turned;
  };
  Point at{pose_.x, pose_.y};
  std::uint8_t highest = 0;
  for (int i = 0; i <= steps; ++i) {
    highest = std::max(highest, footprint.cost(*map_, at, c, s));
    if (highest == Inflation::kLethal || p.occdist_scale * highest > limit) return kIllegal;
    if (i == steps) break;
    turn_half();
    at = {at.x + chord * c, at.y + chord * s};
    turn_half();
  }
  end = {at.x, at.y, slalom::math::atan2(s, c)};
  return p.occdist_scale * highest;
}

double TrajectoryScorer::cost(const Twist& twist, double limit) {
  const Parameters& p = parameters_;
  Pose end;
  const double obstacles = obstacle_cost(twist, limit, end);
  if (obstacles < 0) return kIllegal;
  const Point position{end.x, end.y};
  const double to_path = path_.at(position), to_goal = goal_.at(position);
  if (std::max(to_path, to_goal) >= CostToGo::kUnreached) return kIllegal;
  const Point ahead = to_world(end, {p.forward_point_distance, 0});
  // A point ahead can lie in an obstacle.
  const auto at_most_width = [&](double length) { return std::min(length, p.width); };
  const double alignment = aligns_ ? at_most_width(path_.at(ahead)) : 0;
  const double total = obstacles + p.path_distance_bias * (to_path + alignment) +
                       p.goal_distance_bias * (to_goal + at_most_width(goal_front_.at(ahead)));
  return total <= limit ? total : kIllegal;
}

}  // namespace dwa_local_planner
