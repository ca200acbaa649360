#include "judge.h"
#include "range_finder.h"
#include "simulated_clock.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/methods/registry.h>
#include <slalom/robot/diff_drive.h>
#include <slalom/simulation/simulate.h>

#include <chrono>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

std::string at(const TPose2D& pose, double time) {
  return "at (" + format_fixed(pose.x, 2) + ", " + format_fixed(pose.y, 2) + ") m after " +
         format_fixed(time, 2) + " s";
}

TPoint2D in_robot_frame(const TPose2D& pose, const TPoint2D& point) {
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const double dx = point.x - pose.x, dy = point.y - pose.y;
  return {c * dx + s * dy, -s * dx + c * dy};
}

/// One run, from the start pose to its outcome.
class Run {
 public:
  Run(const World& world, const RobotModel& robot, const SensorModel& sensor,
      const SimulationOptions& options, Method& method)
      : world_(world),
        robot_(robot),
        options_(options),
        method_(method),
        sensor_(world, sensor),
        judge_(world, robot, options),
        vehicle_(robot),
        steps_per_cycle_(static_cast<int>(std::llround(options.control_period / options.step))) {
    vehicle_.start_at(world.scenario().start());
  }

  SimulationResult drive(std::uint64_t seed) {
    if (judge_.touches(pose())) {
      record();
      end(Outcome::UnsolvableScenario, "the robot touches an obstacle where it starts");
      return std::move(result_);
    }
    try {
      reset_method(seed);
      while (!over_) cycle();
    } catch (const std::exception& e) {
      record();
      end(Outcome::MethodError, e.what());
    }
    return std::move(result_);
  }

 private:
  const TPose2D& pose() const { return vehicle_.getCurrentGTPose(); }
  double cycle_time() const { return cycle_ * options_.control_period; }

  void reset_method(std::uint64_t seed) {
    Task task;
    task.start = world_.scenario().start();
    task.goal = world_.scenario().goal();
    task.goal_tolerance = options_.goal_tolerance;
    task.control_period = options_.control_period;
    task.seed = seed;
    method_.reset(task);
  }

  /// Sense, decide, move: one control period.
  void cycle() {
    time_ = cycle_time();
    if (is_over_before_deciding()) return;
    const Command command = ask_method();
    std::string why;
    if (!is_valid_command(command, robot_, why)) {
      record();
      return end(Outcome::MethodInvalidCommand, why + " " + at(pose(), time_));
    }
    command_ = command;
    record();
    vehicle_.command(command.v, command.w);
    move();
    ++cycle_;
  }

  bool is_over_before_deciding() {
    constexpr double kTimeTolerance = 1e-9;
    if (judge_.reached_goal(pose())) {
      record();
      end(Outcome::Success, "goal reached " + at(pose(), time_));
    } else if (time_ >= options_.max_time - kTimeTolerance) {
      record();
      end(Outcome::Timeout, "goal not reached, " + at(pose(), time_));
    } else if (judge_.is_stuck(result_.trajectory, time_, pose())) {
      record();
      end(Outcome::Stuck,
          "no progress for " + format_number(options_.stuck_time) + " s " + at(pose(), time_));
    }
    return over_;
  }

  Command ask_method() {
    clock_.set(time_);
    Observation observation;
    observation.time = time_;
    observation.odometry = vehicle_.getCurrentOdometricPose();
    observation.v = vehicle_.v();
    observation.w = vehicle_.w();
    observation.goal_in_robot = in_robot_frame(observation.odometry, world_.scenario().goal());
    observation.scan = &sensor_.sense(pose(), clock_.now());
    const auto begin = std::chrono::steady_clock::now();
    const Command command = method_.step(observation);
    result_.cycle_seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return command;
  }

  void move() {
    for (int step = 0; step < steps_per_cycle_ && !over_; ++step) {
      const TPose2D before = pose();
      vehicle_.advance(options_.step);
      judge_step(before, cycle_time() + step * options_.step);
    }
  }

  /// What happened on the way from `before` (at time `begin`) to where the vehicle is now.
  void judge_step(const TPose2D& before, double begin) {
    TPose2D now = pose();
    double share = 1;
    const bool contact = judge_.meets_obstacle(before, now, share);
    time_ = begin + share * options_.step;
    if (contact) {
      vehicle_.setCurrentGTPose(now);
      record();
      end(Outcome::Collision, "contact " + at(now, time_));
    } else if (judge_.left_workspace(now)) {
      record();
      end(Outcome::LeftWorkspace, "left " + at(now, time_));
    } else if (judge_.reached_goal(now)) {
      record();
      end(Outcome::Success, "goal reached " + at(now, time_));
    }
  }

  void record() {
    result_.trajectory.samples.push_back(
        {time_, pose(), vehicle_.v(), vehicle_.w(), command_.v, command_.w});
  }

  void end(Outcome outcome, const std::string& detail) {
    result_.outcome = outcome;
    result_.detail = detail;
    over_ = true;
  }

  const World& world_;
  const RobotModel& robot_;
  const SimulationOptions& options_;
  Method& method_;
  SimulatedClock clock_;
  RangeFinder sensor_;
  Judge judge_;
  DiffDrive vehicle_;
  int steps_per_cycle_;
  int cycle_ = 0;
  double time_ = 0;
  Command command_;
  bool over_ = false;
  SimulationResult result_;
};

}  // namespace

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

void SimulationOptions::check(const IniFile& ini, const std::string& section) const {
  const double ratio = control_period / step;
  if (ratio < 0.5 || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw usage_error(
        ini.where(section, "step"), format_number(step) + " s does not divide the control period",
        "control_period (" + format_number(control_period) + " s) divided by a whole number");
}

SimulationResult simulate(const World& world, const RobotModel& robot, const SensorModel& sensor,
                          const SimulationOptions& options, std::uint64_t seed, Method& method) {
  return Run(world, robot, sensor, options, method).drive(seed);
}

}  // namespace slalom
