#pragma once

#include "common/motion.h"
#include "common/plugin.h"

/// Straight to the goal, blind: the control in a comparison. What a place costs without avoidance
/// shows how much of a method's success is the method's.
namespace go_to_goal {

struct Parameters {
  double turn_in_place = 1.0;  ///< rad: beyond this bearing the robot turns without driving
};

class GoToGoal {
 public:
  using Parameters = go_to_goal::Parameters;
  using Settings = reactive::Setting<Parameters>[1];
  static const Settings& settings();

  GoToGoal(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::Task& task);
  reactive::Speeds step(const reactive::Observation& observation);

 private:
  reactive::Robot robot_;
  double tolerance_ = 0.2;
  reactive::TurnOnTheSpot turn_;
};

}  // namespace go_to_goal
