#include <slalom/robot/diff_drive.h>

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::kinematics::CVehicleVelCmd_DiffDriven;
using mrpt::math::TPose2D;

/// `from` moved towards `to` by at most `step`.
double approach(double from, double to, double step) {
  return from + std::clamp(to - from, -step, step);
}

/// The pose after driving with constant (v, w) for dt: an arc, or a straight line.
TPose2D move_along_arc(const TPose2D& pose, double v, double w, double dt) {
  const double turn = w * dt;
  // sin(x)/x with x = turn/2: the chord of the arc, also where the turn vanishes.
  const double half = 0.5 * turn;
  const double chord = v * dt * (std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half);
  const double heading = pose.phi + half;
  return {pose.x + chord * std::cos(heading), pose.y + chord * std::sin(heading),
          mrpt::math::wrapToPi(pose.phi + turn)};
}

}  // namespace

DiffDrive::DiffDrive(const RobotModel& robot) : robot_(robot) {
  start_at({});
}

void DiffDrive::start_at(const TPose2D& pose) {
  resetStatus();
  resetTime();
  setCurrentGTPose(pose);
  setCurrentOdometricPose(pose);
}

void DiffDrive::sendVelCmd(const mrpt::kinematics::CVehicleVelCmd& cmd_vel) {
  const auto* wanted = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&cmd_vel);
  if (wanted == nullptr)
    throw std::invalid_argument("DiffDrive: expected a CVehicleVelCmd_DiffDriven");
  command(wanted->lin_vel, wanted->ang_vel);
}

mrpt::kinematics::CVehicleVelCmd::Ptr DiffDrive::getVelCmdType() const {
  return CVehicleVelCmd_DiffDriven::Create();
}

void DiffDrive::command(double v, double w) {
  command_v_ = std::clamp(v, robot_.forward_only ? 0.0 : -robot_.max_v, robot_.max_v);
  command_w_ = std::clamp(w, -robot_.max_w, robot_.max_w);
}

void DiffDrive::advance(double dt) {
  internal_simulControlStep(dt);
  m_time += dt;
}

void DiffDrive::internal_simulControlStep(const double dt) {
  const double old_v = v_, old_w = w_;
  v_ = approach(v_, command_v_, robot_.max_accel_v * dt);
  w_ = approach(w_, command_w_, robot_.max_accel_w * dt);
  m_GT_pose = move_along_arc(m_GT_pose, 0.5 * (old_v + v_), 0.5 * (old_w + w_), dt);
  m_GT_vel = {v_ * std::cos(m_GT_pose.phi), v_ * std::sin(m_GT_pose.phi), w_};
  m_odometry = m_GT_pose;
  m_odometric_vel = m_GT_vel;
}

void DiffDrive::internal_clear() {
  v_ = w_ = command_v_ = command_w_ = 0;
}

}  // namespace slalom
