// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/wall_clock.h>
#include <slalom/methods/method.h>
#include <slalom/people/hindrance.h>
#include <slalom/people/people_settings.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A limit of time that follows from the scenario is at most that many control periods.
constexpr double kMaxAutoCycles = 1e6;

/// Section [simulation].
struct SimulationOptions {
  double control_period = 0.1;           ///< s, one observation and command per period
  double step = 0.01;                    ///< s, motion and collision step; divides control_period
  std::optional<double> max_time;        ///< s; none: by time_limit()
  double time_factor = 4;                ///< of time_limit()
  double goal_tolerance = 0.2;           ///< m
  double goal_heading_tolerance = 0.25;  ///< rad, of goals with a heading
  double stuck_time = 8;                 ///< s
  double stuck_distance = 0.1;  ///< m: stuck if all positions of the last stuck_time lie within it
  double resolution = 0.05;     ///< m, cell size for scenarios that are not grids

  void visit(OptionVisitor& v);
  /// Throws Error (Usage) unless step divides control_period, and max_time has a feasible number of
  /// control periods.
  void check(const OptionLocation& where) const;
  /// s, the simulated time after which a run is a timeout: max_time. Without one the larger of 60 s
  /// and time_factor times `earliest` (s), the earliest possible arrival as far as it is known, but
  /// at most kMaxAutoCycles control periods.
  double time_limit(double earliest = 0) const;
  /// s, the time without progress after which this robot is stuck: stuck_time, but at least 1.5
  /// times what it takes for a half turn and then stuck_distance, both from standing: within its
  /// limits it could not do better.
  double stuck_limit(const RobotModel& robot) const;
};

/// Throws Error (Usage) unless the period of people is a multiple of the control period: the
/// samples of a run then contain the robot as people saw it.
void check_period(const PeopleSettings& people, const SimulationOptions& simulation,
                  const OptionLocation& where);

/// Whether a pose is within the tolerances of the goal, also that of its heading if it has one.
bool is_at_goal(const Scenario& scenario, const SimulationOptions& options,
                const mrpt::math::TPose2D& pose);

enum class DeadlinePolicy {
  Hold,  ///< keep the last command
  Stop,  ///< the robot brakes
  Fail   ///< the run ends as method_deadline
};
constexpr auto enum_names(DeadlinePolicy) {
  return std::array{"hold", "stop", "fail"};
}

/// The deadline of control cycles (wall clock, so results are not repeatable once it is missed).
/// Part of section [limits].
struct DeadlineOptions {
  double cycle_deadline = 0;  ///< s; 0: none
  DeadlinePolicy deadline_policy = DeadlinePolicy::Fail;

  void visit(OptionVisitor& v);
};

/// The parameters of a run, apart from scenario and method.
struct RunSetup {
  RobotModel robot;
  SensorModel sensor;
  OdometryModel odometry;
  SimulationOptions simulation;
  DeadlineOptions deadline;
  WallClock clock = steady_seconds;  ///< for the deadline and cycle_seconds
  TrackerModel tracker = {};         ///< for methods that use tracks
  PeopleSettings people = {};        ///< for scenarios with people
};

struct SimulationResult {
  Outcome outcome = Outcome::Timeout;
  std::string detail;     ///< human-readable: what happened, where
  Trajectory trajectory;  ///< one sample per control cycle, and the final one
  std::vector<double>
      cycle_seconds;  ///< wall clock of the method's step(), per cycle; not deterministic
  std::map<std::string, double> figures;  ///< Method::run_figures(); not deterministic
  /// All that moved but the robot: the movers of the scenario, then its people.
  Movers movers;
  Hindrances hindrances;  ///< of the people, by the updates up to the end of the run
};

class PeopleAlone;
class RunObserver;

/// Simulates one run of the method in the scenario and determines its outcome from ground truth:
/// collisions are checked with the swept footprint between steps. mrpt::Clock is simulated during
/// the run (it never goes backwards between runs of a process). Exceptions of the method end the
/// run as method_error. Each kind of noise uses its own random stream derived from `seed`. The
/// people of the scenario decide once per period, at the beginning of a control cycle. `alone`, for
/// several runs in a scenario: its people with the settings of `setup`. Throws Error (File) if
/// somebody starts in a wall.
SimulationResult simulate(const World& world, const RunSetup& setup, std::uint64_t seed,
                          Method& method, RunObserver* observer = nullptr,
                          PeopleAlone* alone = nullptr);

}  // namespace slalom
