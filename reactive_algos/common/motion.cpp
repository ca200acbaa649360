// SPDX-License-Identifier: BSD-3-Clause
#include "common/motion.h"

#include <slalom/core/math.h>

#include <algorithm>

namespace reactive {

Turn turn_from(double phi, double w, double time) {
  const double turn = w * time;
  // The chord of an arc: its direction is the middle heading, its length that of the arc times
  // sin(a) / a of half the turn.
  const double half = 0.5 * turn;
  const auto [sine, cosine] = slalom::math::sin_cos(phi + half);
  return {std::abs(half) < 1e-6 ? 1.0 : slalom::math::sin(half) / half, cosine, sine, phi + turn};
}

Pose integrate(const Pose& pose, const Twist& twist, double time) {
  const Turn turn = turn_from(pose.phi, twist.w, time);
  const double chord = twist.v * time * turn.sinc;
  return {pose.x + chord * turn.cosine, pose.y + chord * turn.sine, turn.phi};
}

Twist apply_acceleration_limits(const Twist& from, const Twist& to, const Robot& robot,
                                double time) {
  const double dv = robot.max_accel_v * time, dw = robot.max_accel_w * time;
  return {std::clamp(to.v, from.v - dv, from.v + dv), std::clamp(to.w, from.w - dw, from.w + dw)};
}

namespace {

/// The arcs that are still free, each at the end of its free length so far.
struct OpenArcs {
  PoseBatch poses;
  std::vector<double> curvatures, lengths, steps, turns, clearances;
  std::vector<std::size_t> numbers;  ///< of their twists

  OpenArcs(const Pose& pose, const std::vector<Twist>& twists) {
    poses.assign(twists.size(), pose);
    for (std::vector<double>* column : {&curvatures, &lengths, &steps, &turns, &clearances})
      column->resize(padded(twists.size()));
    for (std::size_t i = 0; i < twists.size(); ++i) {
      if (twists[i].v <= 0) continue;
      curvatures[numbers.size()] = twists[i].w / twists[i].v;
      numbers.push_back(i);
    }
  }

  void move(std::size_t from, std::size_t to) {
    for (std::vector<double>* column :
         {&poses.x, &poses.y, &poses.cosine, &poses.sine, &curvatures, &lengths, &clearances})
      (*column)[to] = (*column)[from];
    numbers[to] = numbers[from];
  }
};

}  // namespace

std::vector<double> free_arc_lengths(const ClearanceMap& map, const Pose& pose,
                                     const std::vector<Twist>& twists, const Robot& robot,
                                     double radius, double limit) {
  constexpr double kMinStep = 0.02;  // m
  const double reach = robot.reach();
  std::vector<double> result(twists.size(), limit);
  OpenArcs open(pose, twists);
  while (!open.numbers.empty()) {
    footprint_clearances(map, open.poses, open.numbers.size(), robot, open.clearances.data());
    std::size_t count = 0;
    for (std::size_t i = 0; i < open.numbers.size(); ++i) {
      // Contact is not possible within the current clearance, which the farthest point covers
      // first.
      const double gap = open.clearances[i] - radius;
      const double step = std::max(gap, kMinStep) / (1 + std::abs(open.curvatures[i]) * reach);
      if (gap < 0) result[open.numbers[i]] = open.lengths[i];
      if (gap < 0 || open.lengths[i] + step >= limit) continue;
      // A polygon takes small steps on narrow circles: once around is enough.
      if (reach > 0 && open.lengths[i] * std::abs(open.curvatures[i]) > 2 * M_PI) continue;
      open.move(i, count);
      open.lengths[count] += step;
      open.steps[count] = step;
      open.turns[count] = step * open.curvatures[count];
      ++count;
    }
    open.numbers.resize(count);
    move_along_arcs(open.steps.data(), open.turns.data(), count, open.poses);
  }
  return result;
}

double clearance_radius(const ClearanceMap& map, const Pose& pose, const Robot& robot,
                        double margin) {
  constexpr double kMinMargin = 0.005;  // m beyond the radius
  const double here = footprint_clearance(map, pose, robot) - kMinMargin;
  return std::clamp(here, robot.radius + kMinMargin, robot.radius + std::max(margin, kMinMargin));
}

bool RotateInPlace::update(double bearing) {
  if (side_ == 0 && std::abs(bearing) > begin_) side_ = bearing > 0 ? 1 : -1;
  if (std::abs(bearing) < end_) side_ = 0;
  // Change the side only if the bearing changes its sign in front of the robot.
  if (side_ * bearing < 0 && std::abs(bearing) < 0.5 * M_PI) side_ = bearing > 0 ? 1 : -1;
  return side_ != 0;
}

bool RotateInPlace::update(double bearing, const ClearanceMap& map, const Pose& pose,
                           const Robot& robot, double margin) {
  if (!update(bearing)) return false;
  const bool behind = side_ * bearing < 0;
  const double angle = (behind ? 2 * M_PI - std::abs(bearing) : std::abs(bearing)) - end_;
  const double radius = clearance_radius(map, pose, robot, margin);
  if (free_rotation(map, pose, robot, radius, side_, angle) < angle) side_ = 0;
  return side_ != 0;
}

std::optional<Twist> brake_on_arc(const Twist& measured, const Robot& robot, double period) {
  const double slowest = std::abs(measured.v) - robot.max_accel_v * period;
  if (slowest <= 0) return std::nullopt;
  return Twist{0, measured.w * slowest / std::abs(measured.v)};
}

Twist RotateInPlace::twist(double bearing, const Twist& measured, const Robot& robot,
                           double period) const {
  if (const auto braking = brake_on_arc(measured, robot, period)) return *braking;
  const bool behind = side_ * bearing < 0;
  return {0, behind ? side_ * robot.max_w : stopping_angular_velocity(bearing, robot)};
}

}  // namespace reactive
