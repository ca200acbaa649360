// SPDX-License-Identifier: BSD-3-Clause
#include "mppi/rollouts.h"

#include <boost/random/normal_distribution.hpp>

#include <algorithm>
#include <cmath>

namespace mppi {

using namespace reactive;

void Noise::seed(std::uint64_t seed) {
  engine_.seed(seed);
}

void Noise::draw(std::size_t rollouts, std::size_t steps, std::size_t hold, double sigma_v,
                 double sigma_w) {
  boost::random::normal_distribution<double> normal;
  rollouts_ = rollouts;
  hold_ = hold;
  const std::size_t samples = (steps + hold - 1) / hold;
  v_.resize(samples * rollouts);
  w_.resize(samples * rollouts);
  // The fixed rollouts draw, too: the other ones do not depend on how many there are.
  for (std::size_t k = 0; k < rollouts; ++k)
    for (std::size_t i = 0; i < samples; ++i) {
      const double v = sigma_v * normal(engine_), w = sigma_w * normal(engine_);
      v_[i * rollouts + k] = k < kFixedRollouts ? 0 : v;
      w_[i * rollouts + k] = k < kFixedRollouts ? 0 : w;
    }
}

namespace {

constexpr double kCollisionCost = 100;  // m of path length, cost of a collision

/// All rollouts at the same time.
class Batch {
 public:
  Batch(const CostRule& rule, const Robot& robot, const Observation& start, std::size_t size)
      : rule_(rule),
        robot_(robot),
        size_(size),
        v_(size, start.measured.v),
        w_(size, start.measured.w),
        lengths_(padded(size)),
        turns_(padded(size)),
        clearances_(padded(size)),
        costs_(size),
        nearest_(size, kCollisionCost),
        sums_(size),
        collided_(size) {
    poses_.assign(size, start.pose);
  }

  void advance(const Twist& mean, const double* noise_v, const double* noise_w);
  /// Adds the costs of the step at `fraction` of the rollouts.
  void add_costs(const Twist& mean, const double* noise_v, const double* noise_w, double fraction,
                 const ClearanceMap& map);
  void approach(const Point& goal);
  std::vector<double> costs_at_end(const Waypoint& target, CostToGo& cost_to_go);

 private:
  double remaining_distance(std::size_t k, const Waypoint& target, CostToGo& cost_to_go) const;

  const CostRule& rule_;
  const Robot& robot_;
  std::size_t size_;
  PoseBatch poses_;
  std::vector<double> v_, w_, lengths_, turns_, clearances_, costs_;
  std::vector<double> nearest_, sums_;  ///< closest approach to the goal until now; its sum
  double steps_ = 0;
  std::vector<char> collided_;
};

void Batch::advance(const Twist& mean, const double* noise_v, const double* noise_w) {
  const double max_v = std::min(robot_.max_v, rule_.top_speed), max_w = robot_.max_w;
  const double dv = robot_.max_accel_v * rule_.period, dw = robot_.max_accel_w * rule_.period;
  const auto clamped = [](double x, double low, double high) {
    const double above = x < low ? low : x;
    return high < above ? high : above;
  };
  for (std::size_t k = 0; k < size_; ++k) {
    const double desired_v = k == Braking ? 0 : clamped(mean.v + noise_v[k], 0, max_v);
    const double desired_w = clamped(mean.w + noise_w[k], -max_w, max_w);
    const double v = clamped(desired_v, v_[k] - dv, v_[k] + dv);
    const double w = clamped(desired_w, w_[k] - dw, w_[k] + dw);
    lengths_[k] = 0.5 * (v_[k] + v) * rule_.period;
    turns_[k] = 0.5 * (w_[k] + w) * rule_.period;
    v_[k] = v;
    w_[k] = w;
  }
  move_along_arcs(lengths_.data(), turns_.data(), size_, poses_);
}

void Batch::add_costs(const Twist& mean, const double* noise_v, const double* noise_w,
                      double fraction, const ClearanceMap& map) {
  footprint_clearances(map, poses_, size_, robot_, clearances_.data());
  const double control_v = rule_.control_v * mean.v, control_w = rule_.control_w * mean.w;
  const double obstacles = rule_.obstacle_weight * rule_.period, per_span = 1 / rule_.span;
  for (std::size_t k = 0; k < size_; ++k) {
    if (collided_[k]) continue;
    const double gap = clearances_[k] - rule_.radius;
    if (gap < 0) {
      collided_[k] = true;
      costs_[k] += kCollisionCost * (2 - fraction);
      continue;
    }
    const double deficit = std::max(0.0, 1 - gap * per_span);
    const double change_v = k == Braking ? -mean.v : noise_v[k];
    costs_[k] += obstacles * deficit * deficit + control_v * change_v + control_w * noise_w[k];
  }
}

void Batch::approach(const Point& goal) {
  for (std::size_t k = 0; k < size_; ++k) {
    const double dx = poses_.x[k] - goal.x, dy = poses_.y[k] - goal.y;
    nearest_[k] = std::min(nearest_[k], std::sqrt(dx * dx + dy * dy));
    sums_[k] += nearest_[k];
  }
  ++steps_;
}

double Batch::remaining_distance(std::size_t k, const Waypoint& target,
                                 CostToGo& cost_to_go) const {
  const Point end = {poses_.x[k], poses_.y[k]};
  const Point ahead = {end.x + rule_.look_ahead * poses_.cosine[k],
                       end.y + rule_.look_ahead * poses_.sine[k]};
  if (!target.reachable) return distance(ahead, target.position);
  const double distance_ahead = cost_to_go.at(ahead);
  return distance_ahead < CostToGo::kUnreached
             ? distance_ahead
             : std::min(kCollisionCost, cost_to_go.at(end) + rule_.look_ahead);
}

/// If the goal is visible, the closest approach counts instead of the end of the rollout, and the
/// earlier the better: by its mean over time, half of the way at constant speed.
std::vector<double> Batch::costs_at_end(const Waypoint& target, CostToGo& cost_to_go) {
  for (std::size_t k = 0; k < size_; ++k)
    if (!collided_[k])
      costs_[k] += rule_.goal_weight * (target.is_goal ? 2 * sums_[k] / steps_
                                                       : remaining_distance(k, target, cost_to_go));
  return std::move(costs_);
}

}  // namespace

std::vector<double> rollout_costs(const CostRule& rule, const Robot& robot,
                                  const Observation& start, const std::vector<Twist>& plan,
                                  const Noise& noise, const ClearanceMap& map,
                                  const Waypoint& target, CostToGo& cost_to_go) {
  Batch batch(rule, robot, start, noise.rollouts());
  for (std::size_t t = 0; t < plan.size(); ++t) {
    batch.advance(plan[t], noise.v(t), noise.w(t));
    const double fraction = static_cast<double>(t) / static_cast<double>(plan.size());
    if (target.is_goal) batch.approach(target.position);
    batch.add_costs(plan[t], noise.v(t), noise.w(t), fraction, map);
  }
  return batch.costs_at_end(target, cost_to_go);
}

}  // namespace mppi
