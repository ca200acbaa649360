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
  /// the first pose of contact and `share` (0..1) how far along that is. The arc driven in a motion
  /// step lies beside the straight line by an eighth of its length times its turn: 0.02 mm with the
  /// default options. Consecutive calls must follow each other: `from` is where the last one ended.
  bool meets_obstacle(const mrpt::math::TPose2D& from, mrpt::math::TPose2D& to, double& share);

  bool reached_goal(const mrpt::math::TPose2D& pose) const;
  bool left_workspace(const mrpt::math::TPose2D& pose) const;
  bool is_in_time(double now) const;    ///< now <= max_time
  bool is_time_over(double now) const;  ///< now >= max_time: nothing more may happen

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
