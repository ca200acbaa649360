// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mover_contact.h"
#include "run_movers.h"

#include <slalom/references/footprint_contact.h>
#include <slalom/scenario/world.h>
#include <slalom/simulation/simulate.h>

#include <mrpt/math/TPose2D.h>

#include <memory>
#include <string>

namespace slalom {

/// Checks the termination conditions of a run from ground truth: collision, goal, stuck, time.
class TerminationChecker {
 public:
  /// Among the static obstacles of `world` and `movers`, which must outlive this.
  TerminationChecker(const World& world, const RunMovers& movers, const RobotModel& robot,
                     const SimulationOptions& options)
      : world_(world),
        movers_(movers),
        contact_(make_footprint_contact(world, robot.shape())),
        mover_contact_(movers.movers(), robot.shape(), movers.max_speed()),
        footprint_(robot.shape()),
        options_(options),
        stuck_time_(options.stuck_limit(robot)) {}

  bool touches(const mrpt::math::TPose2D& pose) const { return contact_->touches(pose); }
  /// The mover that overlaps the robot at time t; null if there is none.
  const Mover* overlapping_mover(const mrpt::math::TPose2D& pose, double t) const {
    return mover_contact_.find_overlap(pose, t);
  }
  /// Whether there is contact on this motion, with an obstacle or a mover; then the motion ends
  /// there and `fraction` (0..1) of it was possible. See FootprintContact, MoverContact.
  bool find_contact(TimedMotion& motion, double& fraction);
  bool reached_goal(const mrpt::math::TPose2D& pose) const;
  bool left_workspace(const mrpt::math::TPose2D& pose) const;
  bool is_in_time(double now) const;    ///< now <= time_limit()
  bool is_time_over(double now) const;  ///< now >= time_limit()

  double stuck_time() const { return stuck_time_; }  ///< s, stuck_limit()
  /// Whether all positions of the last stuck_time() before `now` lie within stuck_distance of the
  /// last one.
  bool is_stuck(const Trajectory& trajectory, double now, const mrpt::math::TPose2D& pose) const;

  /// The contact in the last sample: "contact WHERE", and of one with a mover which, and the
  /// robot's speed, or that it had stood for 0.5 s, so that the mover ran into it (passive safety).
  /// A contact with a person who notices the robot is the robot's doing, see Crowd: it says so.
  std::string describe_contact(const Trajectory& trajectory, const std::string& where) const;

 private:
  const World& world_;
  const RunMovers& movers_;
  std::unique_ptr<FootprintContact> contact_;
  MoverContact mover_contact_;
  Footprint footprint_;
  const SimulationOptions& options_;
  double stuck_time_;
};

}  // namespace slalom
