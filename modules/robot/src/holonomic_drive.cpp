#include "approach.h"

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

/// MRPT's command has a direction in the robot frame and turns towards it with rot_speed.
void HolonomicDrive::sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) {
  const auto* wanted = dynamic_cast<const CVehicleVelCmd_Holo*>(&cmd_vel);
  if (wanted == nullptr)
    throw std::invalid_argument("HolonomicDrive: expected a CVehicleVelCmd_Holo");
  const double turn = wanted->dir_local > 0 ? wanted->rot_speed : -wanted->rot_speed;
  command(wanted->vel * std::cos(wanted->dir_local), wanted->dir_local == 0 ? 0 : turn,
          wanted->vel * std::sin(wanted->dir_local));
}

mrpt::kinematics::CVehicleVelCmd::Ptr HolonomicDrive::getVelCmdType() const {
  return CVehicleVelCmd_Holo::Create();
}

Velocity HolonomicDrive::limited(const Velocity& wanted) const {
  const RobotModel& r = robot();
  const double ahead = r.forward_only ? std::max(0.0, wanted.v) : wanted.v;
  const double speed = std::hypot(ahead, wanted.vy);
  const double scale = speed > r.max_v ? r.max_v / speed : 1;
  return {scale * ahead, std::clamp(wanted.w, -r.max_w, r.max_w), scale * wanted.vy};
}

Velocity HolonomicDrive::approached(const Velocity& from, const Velocity& to, double dt) const {
  const double change = std::hypot(to.v - from.v, to.vy - from.vy);
  const double most = robot().max_accel_v * dt;
  const double scale = change > most ? most / change : 1;
  return {from.v + scale * (to.v - from.v), approach(from.w, to.w, robot().max_accel_w * dt),
          from.vy + scale * (to.vy - from.vy)};
}

TPose2D HolonomicDrive::moved(const TPose2D& pose, const Velocity& velocity, double dt) const {
  const double turn = velocity.w * dt, heading = pose.phi + 0.5 * turn;
  const double c = std::cos(heading), s = std::sin(heading);
  return {pose.x + (c * velocity.v - s * velocity.vy) * dt,
          pose.y + (s * velocity.v + c * velocity.vy) * dt, mrpt::math::wrapToPi(pose.phi + turn)};
}

}  // namespace slalom
