// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/simulation/simulate.h>

#include <algorithm>
#include <cmath>

namespace slalom {

void SimulationOptions::visit(OptionVisitor& v) {
  v.option("control_period", control_period, "s", "time between two observations",
           Range::positive());
  v.option("step", step, "s", "integration and collision checking step; divides control_period",
           Range::positive());
  v.option("max_time", max_time, "s",
           "simulated time after which a run is a timeout; auto: the larger of 60 s and "
           "time_factor times the earliest possible arrival",
           Range::positive(), "auto");
  v.option("time_factor", time_factor, "-", "of max_time = auto", Range::at_least(1));
  v.option("goal_tolerance", goal_tolerance, "m", "distance within which the goal is reached",
           Range::positive());
  v.option("goal_heading_tolerance", goal_heading_tolerance, "rad",
           "difference within which the heading is reached of a goal that has one",
           Range::between(0, M_PI));
  v.option("stuck_time", stuck_time, "s",
           "time without progress after which a run is stuck; at least 1.5 times that of a half "
           "turn and stuck_distance",
           Range::positive());
  v.option("stuck_distance", stuck_distance, "m", "smaller motion counts as no progress",
           Range::positive());
  v.option("resolution", resolution, "m", "cell size for scenarios that are not grids",
           Range::positive());
}

void DeadlineOptions::visit(OptionVisitor& v) {
  v.option("cycle_deadline", cycle_deadline, "s",
           "maximum wall-clock time of a method for a cycle; 0: none", Range::at_least(0));
  v.option("deadline_policy", deadline_policy,
           "on a late command: the last one is held, "
           "the robot stops, or the run fails");
}

void SimulationOptions::check(const OptionLocation& where) const {
  constexpr double kMaxSteps = 1e5;
  constexpr double kMaxCycles = 1e7;  // each adds a sample
  const double ratio = control_period / step;
  const bool divides = ratio > 0.5 && ratio <= kMaxSteps + 0.5 &&
                       std::abs(ratio - std::round(ratio)) <= 1e-6 * ratio;
  if (!divides)
    throw usage_error(where("step"), format_number(step) + " s does not divide the control period",
                      "control_period (" + format_number(control_period) +
                          " s) divided by an integer up to 100000");
  if (max_time && !(*max_time / control_period <= kMaxCycles))
    throw usage_error(where("max_time"),
                      format_number(*max_time) + " s has too many control periods of " +
                          format_number(control_period) + " s",
                      "at most " + format_number(kMaxCycles) + " control periods");
}

double SimulationOptions::time_limit(double earliest) const {
  constexpr double kShortest = 60;  // s
  if (max_time) return *max_time;
  return std::min(std::max(kShortest, time_factor * earliest), kMaxAutoCycles * control_period);
}

double SimulationOptions::stuck_limit(const RobotModel& robot) const {
  constexpr double kAllowance = 1.5;
  const double turn =
      robot.min_turning_radius > 0 ? 0 : M_PI / robot.max_w + robot.max_w / robot.max_accel_w;
  const double move = stuck_distance / robot.max_v + robot.max_v / robot.max_accel_v;
  return std::max(stuck_time, kAllowance * (turn + move + robot.delay + robot.delay_tau));
}

void check_period(const PeopleSettings& people, const SimulationOptions& simulation,
                  const OptionLocation& where) {
  const double ratio = people.period / simulation.control_period;
  if (!(ratio > 0.5 && std::abs(ratio - std::round(ratio)) <= 1e-6 * ratio))
    throw usage_error(
        where("period"),
        format_number(people.period) + " s is not a multiple of the control period",
        "a multiple of control_period (" + format_number(simulation.control_period) + " s)");
}

}  // namespace slalom
