// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/trial.h>

#include <string>
#include <vector>

namespace slalom {

/// The failures in which a witness must reach the goal.
enum class NeedsWitness {
  Never,
  NotForOwn,  ///< in all but those that only the method itself can cause: see needs_witness()
  Always
};

/// When a failure is fair. Each condition can be switched off.
struct FairnessOptions {
  /// Certified width of the widest path from start to goal, in widths of the robot's enclosing
  /// disc; 0: not required.
  double min_bottleneck = 1.5;
  double min_start_clearance =
      0.1;  ///< m, between the robot at the start and obstacles or people; 0: not required
  double min_distance = 1;  ///< m, straight-line distance from start to goal; 0: not required
  bool people_walk = true;  ///< problem_of_people() finds none
  NeedsWitness witness = NeedsWitness::Always;
  bool repeatable = true;  ///< a new process repeats the run bit for bit
};

/// Whether a witness must reach the goal. With NotForOwn it need not where a method collides with
/// what does not move, leaves the workspace, or fails as a program: a robot that stands does not.
bool needs_witness(const FairnessOptions& options, const Scenario& scenario, Outcome outcome);

/// The geometric conditions, which need no run.
struct GeometryReport {
  /// The lower bound of the widest path's width, in robot widths: of all points of the path, not
  /// only the cell centers at which it is searched.
  double bottleneck = 0;
  double start_clearance = 0;  ///< m
  double distance = 0;         ///< m, from start to goal
  std::string violation;       ///< the first condition that is not met; empty if all are
};

GeometryReport judge_geometry(const World& world, const RobotModel& robot,
                              const FairnessOptions& options);

/// Whether judge_geometry() finds no violation, without the values, which takes less time.
bool has_fair_geometry(const World& world, const RobotModel& robot, const FairnessOptions& options);

/// All conditions of a failure.
struct FairnessReport {
  GeometryReport geometry;
  Trial witness_run;                    ///< of the witness that reaches the goal, if there is one
  std::string witness;                  ///< the one that reaches the goal; empty if none does
  bool repeatable = false;              ///< as checked, even if it is not required
  std::vector<std::string> violations;  ///< of the conditions that are required
  bool fair() const { return violations.empty(); }
};

/// Runs the witnesses, and the method once more, each in a new process. `failure` is the trial to
/// repeat.
FairnessReport judge_failure(const FalsificationSetup& setup, const Scenario& scenario,
                             const Trial& failure, const FairnessOptions& options);

}  // namespace slalom
