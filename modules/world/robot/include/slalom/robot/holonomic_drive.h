// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/vehicle.h>

namespace slalom {

/// A holonomic drive: (v, vy, w). The norms of (v, vy) and of its derivative are bounded by max_v
/// and max_accel_v; v >= 0 if the robot is forward only. Within a step it moves straight along its
/// velocity at the mean heading.
class HolonomicDrive : public Vehicle {
 public:
  explicit HolonomicDrive(const RobotModel& robot);

  /// Throws std::invalid_argument when the command is not a CVehicleVelCmd_Holo.
  void sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getVelCmdType() const override;

 private:
  Velocity clamp_to_limits(const Velocity& target) const override;
  Velocity apply_acceleration_limits(const Velocity& from, const Velocity& to,
                                     double dt) const override;
  mrpt::math::TPose2D integrate(const mrpt::math::TPose2D& pose, const Velocity& velocity,
                                double dt) const override;
};

}  // namespace slalom
