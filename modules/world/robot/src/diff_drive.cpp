// SPDX-License-Identifier: BSD-3-Clause
#include "approach.h"

#include <slalom/core/math.h>
#include <slalom/robot/diff_drive.h>

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {

using mrpt::kinematics::CVehicleVelCmd_DiffDriven;
using mrpt::math::TPose2D;

DiffDrive::DiffDrive(const RobotModel& robot) : Vehicle(robot) {
  start_at({});
}

void DiffDrive::sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) {
  const auto* cmd = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&cmd_vel);
  if (cmd == nullptr)
    throw std::invalid_argument("DiffDrive: expected a CVehicleVelCmd_DiffDriven");
  command(cmd->lin_vel, cmd->ang_vel);
}

mrpt::kinematics::CVehicleVelCmd::Ptr DiffDrive::getVelCmdType() const {
  return CVehicleVelCmd_DiffDriven::Create();
}

Velocity DiffDrive::clamp_to_limits(const Velocity& target) const {
  const RobotModel& r = robot();
  return {std::clamp(target.v, r.forward_only ? 0.0 : -r.max_v, r.max_v),
          std::clamp(target.w, -r.max_w, r.max_w), 0};
}

Velocity DiffDrive::apply_acceleration_limits(const Velocity& from, const Velocity& to,
                                              double dt) const {
  const double v = approach(from.v, to.v, robot().max_accel_v * dt);
  const double w = approach(from.w, to.w, robot().max_accel_w * dt);
  if (!(robot().min_turning_radius > 0)) return {v, w, 0};
  const double limit = std::abs(v) / robot().min_turning_radius;
  return {v, std::clamp(w, -limit, limit), 0};
}

TPose2D DiffDrive::integrate(const TPose2D& pose, const Velocity& velocity, double dt) const {
  const double turn = velocity.w * dt;
  // sin(x)/x with x = turn/2: the chord of the arc, also where the turn vanishes.
  const double half = 0.5 * turn;
  const double chord = velocity.v * dt * (std::abs(half) < 1e-9 ? 1.0 : math::sin(half) / half);
  const auto [s, c] = math::sin_cos(pose.phi + half);
  return {pose.x + chord * c, pose.y + chord * s, mrpt::math::wrapToPi(pose.phi + turn)};
}

}  // namespace slalom
