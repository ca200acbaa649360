// SPDX-License-Identifier: BSD-3-Clause
#include "mppi/mppi.h"

#include <slalom/core/math.h>

#include <numeric>

namespace mppi {

using namespace reactive;

namespace {

constexpr double kHeadingLookAhead = 0.3;  // m ahead of the robot, to include its heading
constexpr double kLookAhead = 1.5;         // m along the path to the intermediate target

LocalPlanner local_planner_of(const Parameters& parameters, const Robot& robot, double period) {
  const double reach = robot.max_v * parameters.steps * period + kHeadingLookAhead;
  return {robot, parameters.margin, parameters.comfort,
          std::max(reach, CostToGo::kPathReach * kLookAhead)};
}

}  // namespace

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("samples", samples, "-", "K, rollouts per cycle", Range::between(2, 100000));
  v.option("steps", steps, "-", "T, control periods per rollout", Range::between(2, 1000));
  v.option("lambda", lambda, "m", "temperature", Range::between(1e-6, 1e6));
  v.option("noise_v", noise_v, "m/s", "standard deviation of the noise on v", Range::at_least(0));
  v.option("noise_w", noise_w, "rad/s", "standard deviation of the noise on w", Range::at_least(0));
  v.option("hold", hold, "-", "control periods for which a noise sample is held",
           Range::between(1, 1000));
  v.option("control_cost", control_cost, "-", "gamma of the control term, as a fraction of lambda",
           Range::between(0, 1));
  v.option("margin", margin, "m", "added to the robot's radius in collision checks",
           Range::between(0, 10));
  v.option("comfort", comfort, "m", "clearance of the footprint beyond which there is no cost",
           Range::between(0, 10));
  v.option("obstacle_weight", obstacle_weight, "m/s",
           "path length equivalent to one second at minimum clearance", Range::at_least(0));
  v.option("goal_weight", goal_weight, "-",
           "weight of the remaining distance at the end of a rollout", Range::at_least(0));
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this bearing of the path the robot rotates in place", Range::between(0.1, M_PI));
  v.option("memory", memory, "m", "half the side length of the local map", Range::between(1, 50));
}

std::vector<double> importance_weights(const std::vector<double>& costs, double lambda) {
  double min_cost = HUGE_VAL, sum = 0;
  for (const double cost : costs) min_cost = std::min(min_cost, cost);
  std::vector<double> weights;
  weights.reserve(costs.size());
  for (const double cost : costs) {
    weights.push_back(slalom::math::exp(-(cost - min_cost) / lambda));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

Mppi::Mppi(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(with_cover_discs(robot)),
      map_({parameters.memory, clearance_band(robot_, parameters.margin, parameters.comfort)},
           robot_),
      local_planner_(local_planner_of(parameters, robot_, task_.control_period)),
      turn_(parameters.turn_in_place) {}

void Mppi::reset(const NavigationTask& task) {
  task_ = task;
  local_planner_ = local_planner_of(parameters_, robot_, task.control_period);
  map_.clear();
  turn_.reset();
  noise_.seed(task.seed);
  plan_.assign(static_cast<std::size_t>(parameters_.steps), {0, 0});
}

void Mppi::take_over(Mppi& before) {
  task_ = before.task_;
  map_.take_over(before.map_);
  turn_.take_over(before.turn_);
  local_planner_ = local_planner_of(parameters_, robot_, task_.control_period);
  noise_ = std::move(before.noise_);
  plan_ = std::move(before.plan_);
  plan_.resize(static_cast<std::size_t>(parameters_.steps));
}

CostRule Mppi::cost_rule(const Observation& observation, double top_speed) const {
  CostRule rule;
  rule.period = task_.control_period;
  rule.top_speed = top_speed;
  rule.radius = clearance_radius(map_.clearance(), observation.pose, robot_, parameters_.margin);
  rule.span = std::max(1e-3, robot_.radius + parameters_.comfort - rule.radius);
  rule.obstacle_weight = parameters_.obstacle_weight;
  rule.goal_weight = parameters_.goal_weight;
  const double gamma = parameters_.control_cost * parameters_.lambda;
  rule.control_v = gamma / std::max(1e-9, parameters_.noise_v * parameters_.noise_v);
  rule.control_w = gamma / std::max(1e-9, parameters_.noise_w * parameters_.noise_w);
  // Near the goal the point ahead must not lie beyond it: the robot would stop too early.
  rule.look_ahead = std::min(kHeadingLookAhead,
                             0.5 * slalom::math::hypot(observation.goal.x, observation.goal.y));
  return rule;
}

void Mppi::optimize(const Observation& observation, const Waypoint& target, double top_speed) {
  const auto hold = static_cast<std::size_t>(parameters_.hold);
  noise_.draw(static_cast<std::size_t>(parameters_.samples), plan_.size(), hold,
              parameters_.noise_v, parameters_.noise_w);
  const std::vector<double> weights = importance_weights(
      rollout_costs(cost_rule(observation, top_speed), robot_, observation, plan_, noise_,
                    map_.clearance(), target, local_planner_.cost_to_go()),
      parameters_.lambda);
  Twist mean;  // of the noise
  for (std::size_t t = 0; t < plan_.size(); ++t) {
    if (t % hold == 0)
      mean = {std::inner_product(weights.begin(), weights.end(), noise_.v(t), 0.0),
              std::inner_product(weights.begin(), weights.end(), noise_.w(t), 0.0)};
    const double v = plan_[t].v * (1 - weights[Braking]) + mean.v;
    plan_[t] = clamp_to_limits({v, plan_[t].w + mean.w}, robot_);
    plan_[t].v = std::min(plan_[t].v, top_speed);
  }
}

void Mppi::shift() {
  std::move(plan_.begin() + 1, plan_.end(), plan_.begin());
}

Twist Mppi::step(const Observation& observation) {
  map_.update(observation);
  const Point goal = to_world(observation.pose, observation.goal);
  const Waypoint target = local_planner_.find(map_, observation.pose, goal, kLookAhead);
  const Point seen = to_robot(observation.pose, target.position);
  const double bearing = slalom::math::atan2(seen.y, seen.x);
  const bool rotates =
      turn_.update(bearing, map_.clearance(), observation.pose, robot_, parameters_.margin);
  if (rotates && !brake_on_arc(observation.measured, robot_, task_.control_period)) {
    std::fill(plan_.begin(), plan_.end(), Twist{});
    return clamp_to_limits(turn_.twist(bearing, observation.measured, robot_, task_.control_period),
                           robot_);
  }
  const double goal_distance = slalom::math::hypot(observation.goal.x, observation.goal.y);
  // Before it rotates in place it brakes, on a course that is optimized as well.
  const double top =
      rotates ? 0
              : std::min(robot_.max_v,
                         stopping_speed(goal_distance + 0.5 * task_.goal_tolerance, robot_));
  optimize(observation, target, top);
  const Twist answer = plan_.front();
  shift();
  return answer;
}

}  // namespace mppi
