#pragma once

#include <slalom/scenario/world.h>
#include <slalom/simulation/simulate.h>

#include <mrpt/math/TPose2D.h>

namespace slalom {

/// Decides from ground truth what happens to the disc robot: contact between two instants, goal,
/// stuck.
class Judge {
 public:
  Judge(const World& world, const RobotModel& robot, const SimulationOptions& options)
      : world_(world), radius_(robot.radius), options_(options) {}

  bool touches(const mrpt::math::TPose2D& pose) const;

  /// Whether the disc touches something on its way straight from `from` to `to`; then `to` becomes
  /// the first pose of contact and `share` (0..1) how far along that is.
  bool meets_obstacle(const mrpt::math::TPose2D& from, mrpt::math::TPose2D& to, double& share);

  bool reached_goal(const mrpt::math::TPose2D& pose) const;
  bool left_workspace(const mrpt::math::TPose2D& pose) const;

  /// Whether all positions of the last stuck_time before `now` lie within stuck_distance of the
  /// last one.
  bool is_stuck(const Trajectory& trajectory, double now, const mrpt::math::TPose2D& pose) const;

 private:
  bool is_blocked(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b) const;

  const World& world_;
  double radius_;
  const SimulationOptions& options_;
  /// The robot may move this far (m) before it can touch anything: spares exact tests in open
  /// space.
  double free_travel_ = 0;
};

}  // namespace slalom
