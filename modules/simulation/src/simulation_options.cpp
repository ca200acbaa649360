#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/simulation/simulate.h>

#include <cmath>

namespace slalom {

void SimulationOptions::visit(OptionVisitor& v) {
  v.option("control_period", control_period, "s", "time between two observations",
           Range::positive());
  v.option("step", step, "s", "step of motion and collision tests; divides control_period",
           Range::positive());
  v.option("max_time", max_time, "s", "simulated time after which a run is a timeout",
           Range::positive());
  v.option("goal_tolerance", goal_tolerance, "m", "distance at which the goal counts as reached",
           Range::positive());
  v.option("stuck_time", stuck_time, "s", "time without progress after which a run is stuck",
           Range::positive());
  v.option("stuck_distance", stuck_distance, "m", "moving no further than this is no progress",
           Range::positive());
  v.option("resolution", resolution, "m", "cell size for scenarios that are not grids",
           Range::positive());
}

void DeadlineOptions::visit(OptionVisitor& v) {
  v.option("cycle_deadline", cycle_deadline, "s",
           "wall-clock time a method may take for a cycle; 0: any", Range::at_least(0));
  v.option("deadline_policy", deadline_policy,
           "what a late answer does: the last command is held, "
           "the robot stops, or the run fails",
           {"hold", "stop", "fail"});
}

void SimulationOptions::check(const IniFile& ini, const std::string& section) const {
  constexpr double kMostSteps = 1e5;
  constexpr double kMostCycles = 1e7;  // a sample is kept of each
  const double ratio = control_period / step;
  const bool divides = ratio > 0.5 && ratio <= kMostSteps + 0.5 &&
                       std::abs(ratio - std::round(ratio)) <= 1e-6 * ratio;
  if (!divides)
    throw usage_error(ini.where(section, "step"),
                      format_number(step) + " s does not divide the control period",
                      "control_period (" + format_number(control_period) +
                          " s) divided by a whole number up to 100000");
  if (!(max_time / control_period <= kMostCycles))
    throw usage_error(ini.where(section, "max_time"),
                      format_number(max_time) + " s are too many control periods of " +
                          format_number(control_period) + " s",
                      "at most " + format_number(kMostCycles) + " of them");
}

}  // namespace slalom
