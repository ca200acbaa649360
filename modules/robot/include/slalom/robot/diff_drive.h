#pragma once

#include <slalom/robot/vehicle.h>

namespace slalom {

/// A differential drive: (v, w), each with its own acceleration, v >= 0 when the robot is forward
/// only. It moves along arcs.
class DiffDrive : public Vehicle {
 public:
  explicit DiffDrive(const RobotModel& robot);

  /// Throws std::invalid_argument when the command is not a CVehicleVelCmd_DiffDriven.
  void sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getVelCmdType() const override;

 private:
  Velocity limited(const Velocity& wanted) const override;
  Velocity approached(const Velocity& from, const Velocity& to, double dt) const override;
  mrpt::math::TPose2D moved(const mrpt::math::TPose2D& pose, const Velocity& velocity,
                            double dt) const override;
};

}  // namespace slalom
