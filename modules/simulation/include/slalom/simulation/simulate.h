#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/method.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Section [simulation].
struct SimulationOptions {
  double control_period = 0.1;  ///< s, one observation and command per period
  double step = 0.01;           ///< s, motion and collision step; divides control_period
  double max_time = 60;         ///< s
  double goal_tolerance = 0.2;  ///< m
  double stuck_time = 8;        ///< s
  double stuck_distance =
      0.1;                   ///< m: stuck when all positions of the last stuck_time lie this near
  double resolution = 0.05;  ///< m, cell size for scenarios that are not grids

  void visit(OptionVisitor& v);
  void check(const IniFile& ini,
             const std::string& section) const;  ///< step divides control_period
};

/// What happens when a method takes longer for a cycle than it may (wall clock, so results are no
/// longer repeatable where it happens). Part of section [limits].
struct DeadlineOptions {
  double cycle_deadline = 0;             ///< s; 0: none
  std::string deadline_policy = "fail";  ///< hold: the last command stays; stop: the robot brakes;
                                         ///< fail: the run ends as method_deadline

  void visit(OptionVisitor& v);
};

/// All that a run is simulated with, but for the place and the method.
struct RunSetup {
  RobotModel robot;
  SensorModel sensor;
  OdometryModel odometry;
  SimulationOptions simulation;
  DeadlineOptions deadline;
};

struct SimulationResult {
  Outcome outcome = Outcome::Timeout;
  std::string detail;     ///< for people: what happened, where
  Trajectory trajectory;  ///< one sample per control cycle, and the last instant
  std::vector<double>
      cycle_seconds;  ///< wall clock of the method's step(), per cycle; not deterministic
};

class RunObserver;

/// Drives the robot through the scenario under the method and judges how it ends. Ground truth
/// throughout: collision is judged on the swept footprint between steps. mrpt::Clock is simulated
/// while it runs (it never goes backwards between runs of a process). Exceptions of the method end
/// the run as method_error. Noise comes from streams under `seed`, one for each kind.
SimulationResult simulate(const World& world, const RunSetup& setup, std::uint64_t seed,
                          Method& method, RunObserver* observer = nullptr);

}  // namespace slalom
