#include "eband_local_planner/eband_local_planner.h"

#include <algorithm>

namespace eband_local_planner {

using namespace reactive;

namespace {

/// `wanted`, or `limit` if that is less or `wanted` is 0.
double limited(double wanted, double limit) {
  return wanted > 0 ? std::min(wanted, limit) : limit;
}

constexpr const char* kMaps[] = {"sensed", "known", nullptr};

using P = Parameters;

constexpr EbandLocalPlanner::Settings kSettings = {
    {{"eband_min_relative_overlap", "0.7", "-",
      "distance of neighboring bubbles per sum of their radii"},
     &P::eband_min_relative_overlap,
     0.1,
     1},
    {{"eband_tiny_bubble_distance", "0.01", "m", "bubbles this close do not pull each other"},
     &P::eband_tiny_bubble_distance,
     1e-6,
     1},
    {{"eband_tiny_bubble_expansion", "0.01", "m", "radius of a bubble in collision"},
     &P::eband_tiny_bubble_expansion,
     1e-3,
     1},
    {{"eband_internal_force_gain", "1.0", "-", "of the contraction"},
     &P::eband_internal_force_gain},
    {{"eband_external_force_gain", "2.0", "-", "of the repulsion by obstacles"},
     &P::eband_external_force_gain},
    {{"num_iterations_eband_optimization", "3", "-", "of the band per control cycle"},
     &P::num_iterations_eband_optimization,
     1,
     1000},
    {{"eband_equilibrium_approx_max_recursion_depth", "4", "-",
      "steps to the equilibrium of a bubble"},
     &P::eband_equilibrium_approx_max_recursion_depth,
     0,
     100},
    {{"eband_equilibrium_relative_overshoot", "0.75", "-",
      "opposite force per force before, beyond which steps are shorter"},
     &P::eband_equilibrium_relative_overshoot},
    {{"eband_significant_force_lower_bound", "0.15", "-", "forces below it are ignored then"},
     &P::eband_significant_force_lower_bound},
    {{"costmap_weight", "10.0", "1/m",
      "cost_scaling_factor of the costmap; bubbles have a radius of at most ln(252) / "
      "costmap_weight"},
     &P::costmap_weight,
     0.1,
     1000},
    {{"inflation_radius", "0.55", "m", "clearance beyond which bubbles have the maximum radius"},
     &P::inflation_radius},
    {{"max_vel_lin", "0.0", "m/s", "maximum speed; 0: that of the robot"}, &P::max_vel_lin},
    {{"max_vel_th", "0.0", "rad/s", "maximum angular velocity; 0: that of the robot"},
     &P::max_vel_th},
    {{"min_vel_lin", "0.1", "m/s", "minimum speed"}, &P::min_vel_lin},
    {{"min_vel_th", "0.0", "rad/s", "minimum angular velocity"}, &P::min_vel_th},
    {{"min_in_place_vel_th", "0.0", "rad/s", "minimum angular velocity in place"},
     &P::min_in_place_vel_th},
    {{"k_prop", "4.0", "1/s", "angular velocity per bearing of the next bubble"}, &P::k_prop},
    {{"bubble_velocity_multiplier", "2.0", "1/m",
      "speed per maximum speed and 0.7 radii of the robot's bubble"},
     &P::bubble_velocity_multiplier},
    {{"rotation_threshold_multiplier", "1.0", "-",
      "bearing, per angle that the next bubble subtends, beyond which the robot rotates in "
      "place"},
     &P::rotation_threshold_multiplier},
    {{"planner_frequency", "2.0", "Hz", "frequency of new paths; 0: when the band snaps or ends"},
     &P::planner_frequency,
     0,
     1000},
    {{"footprint_padding", "0.05", "m", "added to the robot's radius"},
     &P::footprint_padding,
     0,
     10},
    {{"comfort", "0.3", "m", "clearance of the footprint beyond which a path does not cost more"},
     &P::comfort,
     0,
     10},
    {{"memory", "6", "m", "half the side length of the local map"}, &P::memory, 1, 50},
    {{"map", "sensed", "-", "known: the path is planned on the map of the environment"},
     &P::map,
     0,
     1,
     kMaps}};

}  // namespace

const EbandLocalPlanner::Settings& EbandLocalPlanner::settings() {
  return kSettings;
}

EbandLocalPlanner::EbandLocalPlanner(const Parameters& parameters, const Robot& robot)
    : parameters_(parameters),
      robot_(robot),
      map_({parameters.memory, 0.05,
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
