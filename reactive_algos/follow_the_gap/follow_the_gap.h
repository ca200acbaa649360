// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace slalom {
class OptionVisitor;
}

/// Follow-the-Gap: V. Sezer and M. Gokasan, "A novel obstacle avoidance algorithm: Follow the Gap
/// Method", Robotics and Autonomous Systems 60 (2012) 1123-1134. Equation numbers refer to it.
namespace follow_the_gap {

/// Angles in rad, counter-clockwise from the heading; lengths in m; speeds in m/s and rad/s.
struct Parameters {
  double alpha = 1.0;          ///< m: weight of the gap against the goal, Eq. (8)
  double margin = 0.1;         ///< m added to the robot's radius when obstacles are enlarged
  double look_ahead = 2.5;     ///< m: obstacles beyond do not close gaps; less while there is none
  double goal_weight = 0.6;    ///< penalty of a gap: twice this per radian from the goal
  double turn_gain = 2.0;      ///< 1/s: w = turn_gain * heading error
  double turn_in_place = 1.0;  ///< rad: beyond this heading error the robot rotates in place

  void visit(slalom::OptionVisitor& v);  ///< in plugin.cpp
};

struct Robot {
  double radius = 0.25, max_v = 1, max_w = 1.5, max_accel_v = 1;
  double aperture = M_PI;
  double max_range = 8;
};

struct Gap {
  double low = 0, high = 0;  ///< directions that are free for the enlarged robot
  double width() const { return high - low; }
  bool contains(double angle) const { return angle >= low && angle <= high; }
};

struct Twist {
  double v = 0, w = 0;
};

using reactive::ray_angle;

/// Gaps between obstacles nearer than `horizon`, each enlarged to a circle of `radius` about its
/// point (section 3.1: a ray is closed if it intersects such a circle), from right to left.
std::vector<Gap> find_gaps(const std::vector<double>& ranges, double aperture, double radius,
                           double horizon);

/// Returns the gap with the largest width minus 2 goal_weight times its angle from the goal, or
/// null if there is none.
const Gap* choose_gap(const std::vector<Gap>& gaps, double goal_angle, double goal_weight);

/// Eq. (8): the weighted mean of gap center and goal angle, with weight alpha / distance of the
/// nearest obstacle, clamped to the gap.
double final_heading(const Gap& gap, double goal_angle, double nearest, double alpha);

/// Returns the distance (m) that a robot of `radius` can move straight ahead before contact.
double free_distance_ahead(const std::vector<double>& ranges, double aperture, double max_range,
                           double radius);

/// Computes one command; the goal is in the robot frame (x ahead, y left). `last_side` keeps the
/// side of the rotation in place (+1 left, -1 right, 0 none), to avoid oscillation.
Twist decide(const std::vector<double>& ranges, double goal_x, double goal_y,
             const Parameters& parameters, const Robot& robot, int& last_side);

/// The command to send: a robot that is to stop, and cannot within `period` s, does not turn until
/// it can, as only the distance straight ahead was checked for obstacles.
Twist stop_before_turning(const Twist& wanted, double measured_v, const Robot& robot,
                          double period);

}  // namespace follow_the_gap
