// SPDX-License-Identifier: BSD-3-Clause
#include "go_to_goal/go_to_goal.h"

#include <slalom/core/math.h>

namespace go_to_goal {

using namespace reactive;

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("turn_in_place", turn_in_place, "rad", "beyond this bearing the robot rotates in place",
           Range::between(0.1, M_PI));
}

GoToGoal::GoToGoal(const Parameters& parameters, const Robot& robot)
    : robot_(robot), turn_(parameters.turn_in_place, 0.3 * parameters.turn_in_place) {}

void GoToGoal::reset(const NavigationTask& task) {
  tolerance_ = task.goal_tolerance;
  control_period_ = task.control_period;
  turn_.reset();
}

void GoToGoal::take_over(GoToGoal& before) {
  tolerance_ = before.tolerance_;
  control_period_ = before.control_period_;
  turn_.take_over(before.turn_);
}

Twist GoToGoal::step(const Observation& observation) {
  const double bearing = slalom::math::atan2(observation.goal.y, observation.goal.x);
  if (turn_.update(bearing))
    return clamp_to_limits(turn_.twist(bearing, observation.measured, robot_, control_period_),
                           robot_);
  const double braking_distance =
      slalom::math::hypot(observation.goal.x, observation.goal.y) + 0.5 * tolerance_;
  const double v =
      std::min(robot_.max_v * slalom::math::cos(bearing), stopping_speed(braking_distance, robot_));
  return clamp_to_limits({v, stopping_angular_velocity(bearing, robot_)}, robot_);
}

}  // namespace go_to_goal
