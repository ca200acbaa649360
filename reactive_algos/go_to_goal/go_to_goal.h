// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/motion.h"
#include "common/plugin.h"

/// Moves straight to the goal without avoidance: the control in a comparison. Its results show how
/// difficult a scenario is without avoidance.
namespace go_to_goal {

struct Parameters {
  double turn_in_place = 1.0;  ///< rad: beyond this bearing the robot rotates in place

  void visit(slalom::OptionVisitor& v);
};

class GoToGoal {
 public:
  using Parameters = go_to_goal::Parameters;

  GoToGoal(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(GoToGoal& before);
  reactive::Twist step(const reactive::Observation& observation);

 private:
  reactive::Robot robot_;
  double tolerance_ = 0.2, control_period_ = 0.1;
  reactive::RotateInPlace turn_;
};

}  // namespace go_to_goal
