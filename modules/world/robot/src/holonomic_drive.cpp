// SPDX-License-Identifier: BSD-3-Clause
#include "approach.h"

#include <slalom/core/math.h>
#include <slalom/robot/holonomic_drive.h>

#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {

using mrpt::kinematics::CVehicleVelCmd_Holo;
using mrpt::math::TPose2D;

HolonomicDrive::HolonomicDrive(const RobotModel& robot) : Vehicle(robot) {
  start_at({});
}

/// MRPT's command has a direction in the robot frame and rotates towards it with rot_speed.
void HolonomicDrive::sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) {
  const auto* cmd = dynamic_cast<const CVehicleVelCmd_Holo*>(&cmd_vel);
  if (cmd == nullptr) throw std::invalid_argument("HolonomicDrive: expected a CVehicleVelCmd_Holo");
  const double turn = cmd->dir_local > 0 ? cmd->rot_speed : -cmd->rot_speed;
  command(cmd->vel * math::cos(cmd->dir_local), cmd->dir_local == 0 ? 0 : turn,
          cmd->vel * math::sin(cmd->dir_local));
}

mrpt::kinematics::CVehicleVelCmd::Ptr HolonomicDrive::getVelCmdType() const {
  return CVehicleVelCmd_Holo::Create();
}

Velocity HolonomicDrive::clamp_to_limits(const Velocity& target) const {
  const RobotModel& r = robot();
  const double forward = r.forward_only ? std::max(0.0, target.v) : target.v;
  const double speed = math::hypot(forward, target.vy);
  const double scale = speed > r.max_v ? r.max_v / speed : 1;
  return {scale * forward, std::clamp(target.w, -r.max_w, r.max_w), scale * target.vy};
}

Velocity HolonomicDrive::apply_acceleration_limits(const Velocity& from, const Velocity& to,
                                                   double dt) const {
  const double change = math::hypot(to.v - from.v, to.vy - from.vy);
  const double max_change = robot().max_accel_v * dt;
  const double scale = change > max_change ? max_change / change : 1;
  return {from.v + scale * (to.v - from.v), approach(from.w, to.w, robot().max_accel_w * dt),
          from.vy + scale * (to.vy - from.vy)};
}

TPose2D HolonomicDrive::integrate(const TPose2D& pose, const Velocity& velocity, double dt) const {
  const double turn = velocity.w * dt;
  const auto [s, c] = math::sin_cos(pose.phi + 0.5 * turn);
  return {pose.x + (c * velocity.v - s * velocity.vy) * dt,
          pose.y + (s * velocity.v + c * velocity.vy) * dt, mrpt::math::wrapToPi(pose.phi + turn)};
}

}  // namespace slalom
