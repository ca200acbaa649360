// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/eband_local_planner.h"

#include <algorithm>

namespace eband_local_planner {

using namespace reactive;

namespace {

/// `wanted`, or `limit` if that is less or `wanted` is 0.
double limited(double wanted, double limit) {
  return wanted > 0 ? std::min(wanted, limit) : limit;
}

}  // namespace

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("eband_min_relative_overlap", eband_min_relative_overlap, "-",
           "distance of neighboring bubbles per sum of their radii", Range::between(0.1, 1));
  v.option("eband_tiny_bubble_distance", eband_tiny_bubble_distance, "m",
           "bubbles this close do not pull each other", Range::between(1e-6, 1));
  v.option("eband_tiny_bubble_expansion", eband_tiny_bubble_expansion, "m",
           "radius of a bubble in collision", Range::between(1e-3, 1));
  v.option("eband_internal_force_gain", eband_internal_force_gain, "-", "of the contraction",
           Range::at_least(0));
  v.option("eband_external_force_gain", eband_external_force_gain, "-",
           "of the repulsion by obstacles", Range::at_least(0));
  v.option("num_iterations_eband_optimization", num_iterations_eband_optimization, "-",
           "of the band per control cycle", Range::between(1, 1000));
  v.option("eband_equilibrium_approx_max_recursion_depth",
           eband_equilibrium_approx_max_recursion_depth, "-",
           "steps to the equilibrium of a bubble", Range::between(0, 100));
  v.option("eband_equilibrium_relative_overshoot", eband_equilibrium_relative_overshoot, "-",
           "relative overshoot of the force above which the step is reduced", Range::at_least(0));
  v.option("eband_significant_force_lower_bound", eband_significant_force_lower_bound, "-",
           "forces below it are ignored then", Range::at_least(0));
  v.option("costmap_weight", costmap_weight, "1/m",
           "cost_scaling_factor of the costmap; bubbles have a radius of at most ln(252) / "
           "costmap_weight",
           Range::between(0.1, 1000));
  v.option("inflation_radius", inflation_radius, "m",
           "clearance beyond which bubbles have the maximum radius", Range::at_least(0));
  v.option("max_vel_lin", max_vel_lin, "m/s", "maximum speed; 0: that of the robot",
           Range::at_least(0));
  v.option("max_vel_th", max_vel_th, "rad/s", "maximum angular velocity; 0: that of the robot",
           Range::at_least(0));
  v.option("min_vel_lin", min_vel_lin, "m/s", "minimum speed", Range::at_least(0));
  v.option("min_vel_th", min_vel_th, "rad/s", "minimum angular velocity", Range::at_least(0));
  v.option("min_in_place_vel_th", min_in_place_vel_th, "rad/s", "minimum angular velocity in place",
           Range::at_least(0));
  v.option("k_prop", k_prop, "1/s", "angular velocity per bearing of the next bubble",
           Range::at_least(0));
  v.option("bubble_velocity_multiplier", bubble_velocity_multiplier, "1/m",
           "speed per maximum speed and 0.7 radii of the robot's bubble", Range::at_least(0));
  v.option(
      "rotation_threshold_multiplier", rotation_threshold_multiplier, "-",
      "bearing, per angle that the next bubble subtends, beyond which the robot rotates in place",
      Range::at_least(0));
  v.option("planner_frequency", planner_frequency, "Hz",
           "frequency of new paths; 0: when the band snaps or ends", Range::between(0, 1000));
  v.option("footprint_padding", footprint_padding, "m", "added to the robot's radius",
           Range::between(0, 10));
  v.option("comfort", comfort, "m",
           "clearance of the footprint beyond which a path does not cost more",
           Range::between(0, 10));
  v.option("memory", memory, "m", "half the side length of the local map", Range::between(1, 50));
  v.option("map", map, "known: the path is planned on the map of the environment");
}

EbandLocalPlanner::EbandLocalPlanner(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(robot),
      map_({parameters.memory,
            clearance_band(robot, parameters.footprint_padding,
                           std::max(parameters.comfort,
                                    parameters.footprint_padding + max_radius(parameters)))},
           robot),
      cost_to_go_(CostToGo::kPathReach * parameters.memory),
      global_map_(
          parameters.memory, map_.clearance().resolution(),
          {inscribed_radius(robot), parameters.inflation_radius, parameters.costmap_weight}),
      band_(parameters, map_.clearance(), inscribed_radius(robot)) {
  parameters_.max_vel_lin = limited(parameters.max_vel_lin, robot.max_v);
  parameters_.max_vel_th = limited(parameters.max_vel_th, robot.max_w);
}

void EbandLocalPlanner::reset(const NavigationTask& task) {
  task_ = task;
  map_.clear();
  band_.clear();
  since_plan_ = 0;
}

void EbandLocalPlanner::take_over(EbandLocalPlanner& before) {
  task_ = before.task_;
  map_.take_over(before.map_);
  global_map_.take_over(before.global_map_);
  band_.take_over(before.band_);
  since_plan_ = before.since_plan_;
}

/// Whether a new path is due, or the band ends before the goal and near the robot.
bool EbandLocalPlanner::is_plan_due(const Point& position, const Point& goal) {
  since_plan_ += task_.control_period;
  if (parameters_.planner_frequency > 0 && since_plan_ * parameters_.planner_frequency > 1 - 1e-6)
    return true;
  if (band_.bubbles().empty()) return true;
  const Point& end = band_.bubbles().back().center;
  return distance(end, goal) > map_.clearance().resolution() &&
         distance(position, end) < 0.5 * parameters_.memory;
}

/// The beginning of a path, at most `memory` meters; empty if there is none.
std::vector<Point> EbandLocalPlanner::path_to(const Point& goal, const Point& position,
                                              double clearance) {
  if (uses_map()) {
    global_map_.build(position, map_.points());
    std::vector<Point> path = global_planner_.plan(global_map_.costs(), position, goal);
    double length = 0;
    std::size_t count = std::min<std::size_t>(1, path.size());
    while (count < path.size() && length <= parameters_.memory) {
      length += distance(path[count - 1], path[count]);
      ++count;
    }
    path.resize(count);
    return path;
  }
  const PathCosts costs{clearance, inscribed_radius(robot_) + parameters_.comfort, 2};
  cost_to_go_.compute(map_.clearance(), goal, position, costs);
  return cost_to_go_.path(position, parameters_.memory);
}

bool EbandLocalPlanner::plan(const Point& position, const Point& goal) {
  constexpr double kMinPadding = 0.01;  // m
  since_plan_ = 0;
  for (const double fraction : {1.0, 0.5, 0.0}) {
    const double clearance = inscribed_radius(robot_) + kMinPadding +
                             fraction * std::max(0.0, parameters_.footprint_padding - kMinPadding);
    std::vector<Point> path = path_to(goal, position, clearance);
    if (path.empty()) continue;
    if (distance(path.back(), goal) < 2 * map_.clearance().resolution()) path.back() = goal;
    path.insert(path.begin(), position);
    if (band_.set_path(path, clearance)) return true;
  }
  return false;
}

Twist EbandLocalPlanner::step(const Observation& observation) {
  map_.update(observation);
  const Point position{observation.pose.x, observation.pose.y};
  const Point goal = to_world(observation.pose, observation.goal);
  const bool connected =
      (!is_plan_due(position, goal) && band_.update(position)) || plan(position, goal);
  const Twist twist = connected ? follow(band_.bubbles(), observation.pose, parameters_)
                                : Twist{0, parameters_.max_vel_th};
  if (twist.v > 0) return twist;
  return brake_on_arc(observation.measured, robot_, task_.control_period).value_or(twist);
}

}  // namespace eband_local_planner
