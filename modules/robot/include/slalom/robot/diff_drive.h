#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/kinematics/CVehicleSimulVirtualBase.h>

namespace slalom {

/// A differential drive as an MRPT vehicle: commanded (v, w) are reached with bounded
/// accelerations, speeds stay within the limits, v >= 0 when the robot is forward only. Within one
/// step v and w change linearly; the pose moves along the arc of their means.
class DiffDrive : public mrpt::kinematics::CVehicleSimulVirtualBase {
 public:
  explicit DiffDrive(const RobotModel& robot);

  /// Stands still at `pose`, odometry equal to it, time 0.
  void start_at(const mrpt::math::TPose2D& pose);

  /// Throws std::invalid_argument when the command is not a CVehicleVelCmd_DiffDriven.
  void sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getVelCmdType() const override;

  void command(double v, double w);  ///< m/s, rad/s; clamped to the robot's limits
  void advance(double dt);           ///< one step of dt seconds, undivided
  double v() const { return v_; }
  double w() const { return w_; }

 private:
  void internal_simulControlStep(const double dt) override;
  void internal_clear() override;

  RobotModel robot_;
  double v_ = 0, w_ = 0, command_v_ = 0, command_w_ = 0;
};

}  // namespace slalom
