// SPDX-License-Identifier: BSD-3-Clause
#include "common/plugin.h"
#include "follow_the_gap.h"

namespace follow_the_gap {
namespace {

class Method {
 public:
  using Parameters = follow_the_gap::Parameters;

  Method(const Parameters& parameters, const reactive::Robot& robot)
      : parameters_(parameters), robot_{robot.radius,      robot.max_v,    robot.max_w,
                                        robot.max_accel_v, robot.aperture, robot.max_range} {}

  void reset(const reactive::NavigationTask& task) {
    control_period_ = task.control_period;
    last_side_ = 0;
  }

  void take_over(const Method& before) {
    control_period_ = before.control_period_;
    last_side_ = before.last_side_;
  }

  reactive::Twist step(const reactive::Observation& observation) {
    const Twist wanted = decide(observation.ranges, observation.goal.x, observation.goal.y,
                                parameters_, robot_, last_side_);
    const Twist twist =
        stop_before_turning(wanted, observation.measured.v, robot_, control_period_);
    return {twist.v, twist.w};
  }

 private:
  Parameters parameters_;
  Robot robot_;
  double control_period_ = 0.1;  // s
  int last_side_ = 0;
};

}  // namespace

void Parameters::visit(slalom::OptionVisitor& v) {
  using slalom::Range;
  v.option("alpha", alpha, "m", "weight of the gap against the goal, Eq. (8)", Range::at_least(0));
  v.option("margin", margin, "m", "added to the robot's radius when obstacles are enlarged",
           Range::at_least(0));
  v.option("look_ahead", look_ahead, "m", "obstacles beyond this distance do not close gaps",
           Range::at_least(0));
  v.option("goal_weight", goal_weight, "-", "penalty of a gap: twice this per radian from the goal",
           Range::at_least(0));
  v.option("turn_gain", turn_gain, "1/s", "angular velocity per radian of heading error",
           Range::at_least(0));
  v.option("turn_in_place", turn_in_place, "rad",
           "beyond this heading error the robot rotates in place", Range::at_least(0));
}

}  // namespace follow_the_gap

const slalom_method_api* slalom_method_get_api(void) {
  return reactive::Plugin<follow_the_gap::Method>::table("follow_the_gap");
}

const slalom_goal_heading_api* slalom_method_get_goal_heading_api(void) {
  return reactive::Plugin<follow_the_gap::Method>::goal_heading_table();
}

const slalom_space_api* slalom_method_get_space_api(void) {
  return reactive::Plugin<follow_the_gap::Method>::space_table({{"alpha", 0.1, 10, 1, 0},
                                                                {"margin", 0, 0.3, 0, 0},
                                                                {"look_ahead", 0.5, 5, 1, 0},
                                                                {"goal_weight", 0.1, 5, 1, 0},
                                                                {"turn_gain", 0.5, 6, 1, 0},
                                                                {"turn_in_place", 0.2, 2, 0, 0}});
}

const slalom_parameters_api* slalom_method_get_parameters_api(void) {
  return reactive::Plugin<follow_the_gap::Method>::parameters_table();
}
