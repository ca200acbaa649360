// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/vehicle.h>

namespace slalom {

/// A differential drive: (v, w), each with its own acceleration limit, v >= 0 if the robot is
/// forward only. It moves along arcs.
class DiffDrive : public Vehicle {
 public:
  explicit DiffDrive(const RobotModel& robot);

  /// Throws std::invalid_argument when the command is not a CVehicleVelCmd_DiffDriven.
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
