// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/robot/diff_drive.h>
#include <slalom/robot/holonomic_drive.h>
#include <slalom/robot/vehicle.h>

#include <cmath>

namespace slalom {
namespace {

/// Tolerance (s) for rounding errors of times, which are sums of steps.
constexpr double kTimeTolerance = 1e-9;

Velocity mean(const Velocity& a, const Velocity& b) {
  return {0.5 * (a.v + b.v), 0.5 * (a.w + b.w), 0.5 * (a.vy + b.vy)};
}

}  // namespace

void Vehicle::start_at(const mrpt::math::TPose2D& pose) {
  resetStatus();
  resetTime();
  setCurrentGTPose(pose);
  setCurrentOdometricPose(pose);
}

void Vehicle::command(double v, double w, double vy) {
  pending_commands_.push_back({m_time + robot_.delay, clamp_to_limits({v, w, vy})});
}

void Vehicle::advance(double dt) {
  move(dt);
  m_time += dt;
}

Velocity Vehicle::delayed_command(double dt) {
  while (!pending_commands_.empty() &&
         pending_commands_.front().effective_at <= m_time + kTimeTolerance) {
    effective_command_ = pending_commands_.front().velocity;
    pending_commands_.pop_front();
  }
  if (!(robot_.delay_tau > 0)) return effective_command_;
  const double gain = 1 - math::exp(-dt / robot_.delay_tau);
  return {velocity_.v + gain * (effective_command_.v - velocity_.v),
          velocity_.w + gain * (effective_command_.w - velocity_.w),
          velocity_.vy + gain * (effective_command_.vy - velocity_.vy)};
}

void Vehicle::move(double dt) {
  const Velocity before = velocity_;
  velocity_ = apply_acceleration_limits(before, delayed_command(dt), dt);
  const Velocity driven = mean(before, velocity_);
  m_GT_pose = integrate(m_GT_pose, driven, dt);
  m_odometry = m_GT_pose;
  step_length_ = math::hypot(driven.v, driven.vy) * dt;
}

void Vehicle::internal_simulControlStep(const double dt) {
  move(dt);
  const auto [s, c] = math::sin_cos(m_GT_pose.phi);
  m_GT_vel = {velocity_.v * c - velocity_.vy * s, velocity_.v * s + velocity_.vy * c, velocity_.w};
  m_odometric_vel = m_GT_vel;
}

void Vehicle::internal_clear() {
  velocity_ = effective_command_ = {};
  step_length_ = 0;
  pending_commands_.clear();
}

std::unique_ptr<Vehicle> make_vehicle(const RobotModel& robot) {
  if (robot.holonomic()) return std::make_unique<HolonomicDrive>(robot);
  return std::make_unique<DiffDrive>(robot);
}

}  // namespace slalom
