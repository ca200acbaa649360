#pragma once

#include <slalom/robot/vehicle.h>

namespace slalom {

/// A drive that moves to any side: (v, vy, w). The length of (v, vy) and of its change are bounded
/// by max_v and max_accel_v; v >= 0 when the robot is forward only. Within a step it moves straight
/// along its velocity in the middle heading.
class HolonomicDrive : public Vehicle {
 public:
  explicit HolonomicDrive(const RobotModel& robot);

  /// Throws std::invalid_argument when the command is not a CVehicleVelCmd_Holo.
  void sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getVelCmdType() const override;

 private:
  Velocity limited(const Velocity& wanted) const override;
  Velocity approached(const Velocity& from, const Velocity& to, double dt) const override;
  mrpt::math::TPose2D moved(const mrpt::math::TPose2D& pose, const Velocity& velocity,
                            double dt) const override;
};

}  // namespace slalom
