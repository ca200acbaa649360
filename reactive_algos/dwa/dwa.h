// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <vector>

/// Dynamic Window Approach: D. Fox, W. Burgard and S. Thrun, "The Dynamic Window Approach to
/// Collision Avoidance", IEEE Robotics & Automation Magazine 4(1), 1997, 23-33. Equation numbers
/// refer to it. With `guidance` the heading is that of a navigation function: O. Brock and
/// O. Khatib, "High-speed navigation using the global dynamic window approach", ICRA 1999.
namespace dwa {

/// Lengths in m, times in s.
struct Parameters {
  double alpha = 0.8;          ///< weight of the heading, Eq. (13)
  double beta = 0.2;           ///< weight of the free distance
  double gamma = 0.3;          ///< weight of the velocity
  double margin = 0.05;        ///< added to the robot's radius
  double horizon = 2.0;        ///< free distance at which the term saturates
  int v_samples = 13;          ///< linear velocities in the window
  int w_samples = 41;          ///< angular velocities in the window
  double turn_in_place = 1.6;  ///< rad: beyond this bearing of the path the robot rotates in place
  double memory = 15;          ///< half the side length of the local map
  bool guidance = false;       ///< along the navigation function of the map, not to the goal
  double look_ahead = 1.5;     ///< with guidance: look-ahead distance along the path

  void visit(slalom::OptionVisitor& v);
};

/// A pair of velocities with the three terms of the objective, each in [0, 1].
struct Candidate {
  reactive::Twist twist;
  bool admissible = false;
  double heading = 0, clearance = 0, velocity = 0;
};

/// The dynamic window, Eq. (12): velocities that the robot can reach within `period`.
struct Window {
  reactive::Twist low, high;
};
Window dynamic_window(const reactive::Twist& now, const reactive::Robot& robot, double period);

/// Eq. (14): whether the robot can stop on its arc within `free_distance`.
bool can_stop(const reactive::Twist& twist, double free_distance, const reactive::Robot& robot,
              double period);

/// The heading term: 1 if the robot faces `target`, 0 if it faces away, at its predicted pose after
/// one period with these velocities and braking of its rotation.
double heading_term(const reactive::Pose& pose, const reactive::Twist& twist,
                    const reactive::Point& target, const reactive::Robot& robot, double period);

class Dwa {
 public:
  using Parameters = dwa::Parameters;

  Dwa(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(Dwa& before);
  reactive::Twist step(const reactive::Observation& observation);

 private:
  reactive::Waypoint target(const reactive::Observation& observation);
  void evaluate(const reactive::Observation& observation, const reactive::Point& target,
                double top_speed);
  reactive::Twist best(const reactive::Twist& measured) const;
  double smoothed(std::size_t v, std::size_t w) const;

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::LocalPlanner local_planner_;
  reactive::RotateInPlace turn_;
  std::vector<Candidate> candidates_;  ///< rows of equal v
};

}  // namespace dwa
