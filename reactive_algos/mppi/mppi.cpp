#include "mppi/mppi.h"

#include <boost/random/normal_distribution.hpp>

namespace mppi {

using namespace reactive;

namespace {

constexpr double kCollisionCost = 100;     // m of path length, cost of a collision
constexpr double kHeadingLookAhead = 0.3;  // m ahead of the robot, to include its heading

}  // namespace

const Mppi::Settings& Mppi::settings() {
  static constexpr Settings kSettings = {
      {{"samples", "400", "-", "K, rollouts per cycle"}, &Parameters::samples, 2, 100000},
      {{"steps", "24", "-", "T, control periods per rollout"}, &Parameters::steps, 2, 1000},
      {{"lambda", "0.3", "m", "temperature"}, &Parameters::lambda, 1e-6, 1e6},
      {{"noise_v", "0.2", "m/s", "standard deviation of the noise on v"}, &Parameters::noise_v},
      {{"noise_w", "0.6", "rad/s", "standard deviation of the noise on w"}, &Parameters::noise_w},
      {{"hold", "4", "-", "control periods for which a noise sample is held"},
       &Parameters::hold,
       1,
       1000},
      {{"control_cost", "0.02", "-", "gamma of the control term, as a fraction of lambda"},
       &Parameters::control_cost,
       0,
       1},
      {{"margin", "0.04", "m", "added to the robot's radius in collision checks"},
       &Parameters::margin,
       0,
       10},
      {{"comfort", "0.3", "m", "clearance of the footprint beyond which there is no cost"},
       &Parameters::comfort,
       0,
       10},
      {{"obstacle_weight", "1.5", "m/s",
        "path length equivalent to one second at minimum clearance"},
       &Parameters::obstacle_weight},
      {{"goal_weight", "4.0", "-", "weight of the remaining distance at the end of a rollout"},
       &Parameters::goal_weight},
      {{"turn_in_place", "1.6", "rad",
        "beyond this bearing of the path the robot rotates in place"},
       &Parameters::turn_in_place,
       0.1,
       M_PI},
      {{"memory", "6", "m", "half the side length of the local map"}, &Parameters::memory, 1, 50}};
  return kSettings;
}

std::vector<double> importance_weights(const std::vector<double>& costs, double lambda) {
  double min_cost = HUGE_VAL, sum = 0;
  for (const double cost : costs) min_cost = std::min(min_cost, cost);
  std::vector<double> weights;
  weights.reserve(costs.size());
  for (const double cost : costs) {
    weights.push_back(std::exp(-(cost - min_cost) / lambda));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

void Noise::seed(std::uint64_t seed) {
  engine_.seed(seed);
}

void Noise::draw(std::vector<Twist>& out, std::size_t rollouts, std::size_t steps, std::size_t hold,
                 double sigma_v, double sigma_w) {
  boost::random::normal_distribution<double> normal;
  out.resize(rollouts * steps);
  for (std::size_t k = 0; k < rollouts; ++k)
    for (std::size_t t = 0; t < steps; ++t) {
      Twist& twist = out[k * steps + t];
      if (t % hold == 0)
        twist = {sigma_v * normal(engine_), sigma_w * normal(engine_)};
      else
        twist = out[k * steps + t - 1];
    }
}

Mppi::Mppi(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(robot),
      map_({parameters.memory, 0.05, robot.radius + std::max(0.8, parameters.comfort)}, robot),
      local_planner_(
          {robot.radius + parameters.margin + 0.01, robot.radius + parameters.comfort, 2.0},
          robot.radius + 0.01),
      turn_(parameters.turn_in_place, 0.4) {}

void Mppi::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  turn_.reset();
  noise_.seed(task.seed);
  plan_.assign(static_cast<std::size_t>(parameters_.steps), {0, 0});
}

double Mppi::remaining_distance(const Pose& pose, const Waypoint& target) const {
  const Point ahead = to_world(pose, {heading_look_ahead_, 0});
  if (!target.reachable) return distance(ahead, target.position);
  const double distance_ahead = local_planner_.cost_to_go().at(ahead);
  return distance_ahead < CostToGo::kUnreached
             ? distance_ahead
             : std::min(kCollisionCost,
                        local_planner_.cost_to_go().at({pose.x, pose.y}) + heading_look_ahead_);
}

/// Cost S of a rollout, Algorithm 2: state costs, control term gamma u^T Sigma^-1 epsilon, and
/// terminal cost.
double Mppi::rollout_cost(const Observation& observation, const Waypoint& target, double top_speed,
                          double radius, const Twist* noise) {
  const double period = task_.control_period;
  const double gamma = parameters_.control_cost * parameters_.lambda;
  const double vv = std::max(1e-9, parameters_.noise_v * parameters_.noise_v);
  const double ww = std::max(1e-9, parameters_.noise_w * parameters_.noise_w);
  const double span = std::max(1e-3, robot_.radius + parameters_.comfort - radius);
  Pose pose = observation.pose;
  Twist now = observation.measured;
  double cost = 0, nearest = kCollisionCost;
  for (std::size_t t = 0; t < plan_.size(); ++t) {
    const Twist& mean = plan_[t];
    Twist desired = clamp_to_limits({mean.v + noise[t].v, mean.w + noise[t].w}, robot_);
    desired.v = std::min(desired.v, top_speed);
    const Twist next = apply_acceleration_limits(now, desired, robot_, period);
    pose = integrate(pose, {0.5 * (now.v + next.v), 0.5 * (now.w + next.w)}, period);
    now = next;
    nearest = std::min(nearest, distance({pose.x, pose.y}, target.position));
    const double gap = map_.clearance().at({pose.x, pose.y}) - radius;
    if (gap < 0)
      return cost +
             kCollisionCost * (2 - static_cast<double>(t) / static_cast<double>(plan_.size()));
    const double deficit = std::max(0.0, 1 - gap / span);
    cost += parameters_.obstacle_weight * period * deficit * deficit;
    cost += gamma * (mean.v * noise[t].v / vv + mean.w * noise[t].w / ww);
  }
  // If the goal is visible, the closest approach counts instead of the end of the rollout.
  return cost +
         parameters_.goal_weight * (target.is_goal ? nearest : remaining_distance(pose, target));
}

void Mppi::optimize(const Observation& observation, const Waypoint& target, double top_speed) {
  const std::size_t steps = plan_.size();
  const auto samples = static_cast<std::size_t>(parameters_.samples);
  const double radius =
      clearance_radius(map_.clearance(), observation.pose, robot_, parameters_.margin);
  noise_.draw(disturbance_, samples, steps, static_cast<std::size_t>(parameters_.hold),
              parameters_.noise_v, parameters_.noise_w);
  // The first rollout is the unchanged plan, the second one brakes.
  for (std::size_t t = 0; t < steps; ++t) {
    disturbance_[t] = {0, 0};
    disturbance_[steps + t] = {-plan_[t].v, 0};
  }
  std::vector<double> costs(samples);
  for (std::size_t k = 0; k < samples; ++k)
    costs[k] = rollout_cost(observation, target, top_speed, radius, &disturbance_[k * steps]);
  const std::vector<double> weights = importance_weights(costs, parameters_.lambda);
  for (std::size_t t = 0; t < steps; ++t) {
    Twist change;
    for (std::size_t k = 0; k < samples; ++k) {
      change.v += weights[k] * disturbance_[k * steps + t].v;
      change.w += weights[k] * disturbance_[k * steps + t].w;
    }
    plan_[t] = clamp_to_limits({plan_[t].v + change.v, plan_[t].w + change.w}, robot_);
    plan_[t].v = std::min(plan_[t].v, top_speed);
  }
}

void Mppi::shift() {
  std::move(plan_.begin() + 1, plan_.end(), plan_.begin());
}

Twist Mppi::step(const Observation& observation) {
  map_.update(observation);
  const Point goal = to_world(observation.pose, observation.goal);
  // Near the goal the point ahead must not lie beyond it: the robot would stop too early.
  heading_look_ahead_ =
      std::min(kHeadingLookAhead, 0.5 * std::hypot(observation.goal.x, observation.goal.y));
  const Waypoint target = local_planner_.find(map_, observation.pose, goal, 1.5);
  const Point seen = to_robot(observation.pose, target.position);
  const double bearing = std::atan2(seen.y, seen.x);
  if (turn_.update(bearing)) {
    std::fill(plan_.begin(), plan_.end(), Twist{});
    return clamp_to_limits(turn_.twist(bearing, robot_), robot_);
  }
  const double goal_distance = std::hypot(observation.goal.x, observation.goal.y);
  const double top =
      std::min(robot_.max_v, stopping_speed(goal_distance + 0.5 * task_.goal_tolerance, robot_));
  optimize(observation, target, top);
  const Twist answer = plan_.front();
  shift();
  return answer;
}

}  // namespace mppi
