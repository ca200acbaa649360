#pragma once

#include <slalom/scenario/world.h>
#include <slalom/simulation/footprint_contact.h>
#include <slalom/simulation/simulate.h>

#include <mrpt/math/TPose2D.h>

namespace slalom {

/// Checks the termination conditions of a run from ground truth: collision, goal, stuck, time.
class TerminationChecker {
 public:
  TerminationChecker(const World& world, const RobotModel& robot, const SimulationOptions& options)
      : world_(world), contact_(make_footprint_contact(world, robot.shape())), options_(options) {}

  bool touches(const mrpt::math::TPose2D& pose) const { return contact_->touches(pose); }
  /// See FootprintContact.
  bool find_contact(const mrpt::math::TPose2D& from, mrpt::math::TPose2D& to, double& fraction) {
    return contact_->find_contact(from, to, fraction);
  }
  bool reached_goal(const mrpt::math::TPose2D& pose) const;
  bool left_workspace(const mrpt::math::TPose2D& pose) const;
  bool is_in_time(double now) const;    ///< now <= max_time
  bool is_time_over(double now) const;  ///< now >= max_time

  /// Whether all positions of the last stuck_time before `now` lie within stuck_distance of the
  /// last one.
  bool is_stuck(const Trajectory& trajectory, double now, const mrpt::math::TPose2D& pose) const;

 private:
  const World& world_;
  std::unique_ptr<FootprintContact> contact_;
  const SimulationOptions& options_;
};

}  // namespace slalom
