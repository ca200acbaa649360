// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <vector>

/// Regulated pure pursuit: S. Macenski, S. Singh, F. Martin and J. Gines, "Regulated Pure Pursuit
/// for Robot Path Tracking", Autonomous Robots 47, 2023, 685-694 (arXiv:2305.20026). The path is
/// that of the navigation function on the local map. Parameters have the names and, where robots
/// of 1 m/s allow it, the default values of nav2's controller.
namespace regulated_pure_pursuit {

/// Lengths in m, times in s.
struct Parameters {
  double desired_linear_vel = 1.0;  ///< m/s, at most that of the robot
  double lookahead_time = 1.5;      ///< of the velocity-scaled look-ahead distance
  double min_lookahead_dist = 0.3;
  double max_lookahead_dist = 0.9;
  double regulated_linear_scaling_min_radius = 0.9;  ///< of turns that do not slow the robot
  double regulated_linear_scaling_min_speed = 0.25;  ///< m/s, of the two regulations
  double cost_scaling_dist = 0.6;  ///< clearance of the footprint that does not slow the robot
  double cost_scaling_gain = 1.0;
  double approach_velocity_scaling_dist = 0.6;  ///< to the goal
  double min_approach_linear_velocity = 0.05;   ///< m/s
  double max_allowed_time_to_collision_up_to_carrot = 1.0;
  double rotate_to_heading_min_angle = 0.785;  ///< rad: beyond this bearing it rotates in place
  double margin = 0.04;                        ///< added to the robot's radius
  double comfort = 0.3;                        ///< clearance beyond which paths do not cost more
  double memory = 15;                          ///< half the side length of the local map

  void visit(slalom::OptionVisitor& v);
};

/// Point at which `path`, which begins at the origin, leaves the circle of radius `distance` (m)
/// around the origin; its end if it does not.
reactive::Point carrot_of(const std::vector<reactive::Point>& path, double distance);

/// The curvature (1/m, left positive) of the arc from the robot to `carrot` (robot frame):
/// R. Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", CMU-RI-TR-92-01, 1992.
double curvature_to(const reactive::Point& carrot);

/// The speed (m/s) on an arc of `curvature` at `clearance` m from obstacles: the smaller one of the
/// curvature heuristic and the proximity heuristic of section 3 of the paper, then slower near the
/// goal, `goal_distance` m ahead. Proximity is that of the center, as nav2 has it:
/// `inscribed_radius` (m) is added to both the clearance and cost_scaling_dist.
double regulated_speed(const Parameters& parameters, double inscribed_radius, double curvature,
                       double clearance, double goal_distance);

class RegulatedPurePursuit {
 public:
  using Parameters = regulated_pure_pursuit::Parameters;

  RegulatedPurePursuit(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(RegulatedPurePursuit& before);
  reactive::Twist step(const reactive::Observation& observation);

 private:
  std::vector<reactive::Point> path(const reactive::Pose& pose, const reactive::Point& goal);
  reactive::Point carrot(const reactive::Observation& observation);
  bool is_collision_imminent(const reactive::Pose& pose, const reactive::Twist& twist,
                             double radius, double carrot_distance) const;

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::LocalPlanner local_planner_;
  reactive::RotateInPlace turn_;
};

}  // namespace regulated_pure_pursuit
