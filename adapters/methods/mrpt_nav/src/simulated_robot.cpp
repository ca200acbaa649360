// SPDX-License-Identifier: BSD-3-Clause
#include "sectors.h"
#include "simulated_robot.h"

#include <slalom/core/math.h>

#include <mrpt/core/Clock.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {

using mrpt::kinematics::CVehicleVelCmd;
using mrpt::kinematics::CVehicleVelCmd_DiffDriven;
using mrpt::kinematics::CVehicleVelCmd_Holo;
using mrpt::math::TPoint2D;

namespace {

TPoint2D rotated(const TPoint2D& p, double angle) {
  const double c = math::cos(angle), s = math::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Factor that scales a speed to at most `limit`.
double limit_scale(double speed, double limit) {
  return std::abs(speed) > limit ? limit / std::abs(speed) : 1;
}

/// Rounds to multiples of 2^-20 s, whose differences are exact.
double exact(double seconds) {
  return std::round(std::ldexp(seconds, 20)) * std::ldexp(1, -20);
}

}  // namespace

SimulatedRobot::SimulatedRobot(const RobotModel& robot, double obstacle_height)
    : robot_(robot), obstacle_height_(obstacle_height) {
  logging_enable_console_output = false;
  setMinLoggingLevel(mrpt::system::LVL_ERROR);
}

void SimulatedRobot::start_run(double control_period) {
  run_begin_ = std::ceil(now()) + kTimerBegin;
  control_period_ = control_period;
  observation_ = {};
  active_command_ = Stop{};
}

void SimulatedRobot::restart_timer() {
  run_begin_ = kTimerBegin;
  timer_zero_ = 0;
}

void SimulatedRobot::observe(const Observation& observation) {
  observation_ = observation;
}

double SimulatedRobot::now() const {
  return run_begin_ + exact(observation_.time);
}

double SimulatedRobot::getNavigationTime() {
  return now() - timer_zero_;
}

TPoint2D SimulatedRobot::world_velocity() const {
  return rotated({observation_.v, observation_.vy}, observation_.odometry.phi);
}

bool SimulatedRobot::getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose,
                                             mrpt::math::TTwist2D& velocity,
                                             mrpt::system::TTimeStamp& timestamp,
                                             mrpt::math::TPose2D& odometry, std::string&) {
  pose = odometry = observation_.odometry;
  const TPoint2D speed = world_velocity();
  velocity = {speed.x, speed.y, observation_.w};
  timestamp = mrpt::Clock::now();
  return true;
}

bool SimulatedRobot::senseObstacles(mrpt::maps::CSimplePointsMap& obstacles,
                                    mrpt::system::TTimeStamp& timestamp) {
  // Points would accumulate over the cycles.
  obstacles.clear();
  if (observation_.scan == nullptr) return false;
  const auto height = static_cast<float>(obstacle_height_);
  for (const TPoint2D& point : obstacle_points(*observation_.scan))
    obstacles.insertPoint(static_cast<float>(point.x), static_cast<float>(point.y), height);
  timestamp = observation_.scan->timestamp;
  return true;
}

bool SimulatedRobot::changeSpeeds(const CVehicleVelCmd& command) {
  if (const auto* diff_drive = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&command)) {
    active_command_ = DiffDrive{diff_drive->lin_vel, diff_drive->ang_vel};
    return true;
  }
  const auto* holo = dynamic_cast<const CVehicleVelCmd_Holo*>(&command);
  if (holo == nullptr || !robot_.holonomic())
    throw MethodError(std::string("unsupported command ") + command.GetRuntimeClass()->className +
                      " for a " + to_string(robot_.kinematics) + " robot");
  const double heading = observation_.odometry.phi + holo->dir_local;
  active_command_ = Holo{
      holo->ramp_time, holo->rot_speed, now(), world_velocity(), rotated({holo->vel, 0}, heading),
      heading};
  return true;
}

bool SimulatedRobot::stop(bool) {
  active_command_ = Stop{};
  return true;
}

CVehicleVelCmd::Ptr SimulatedRobot::getStopCmd() {
  if (robot_.holonomic()) return std::make_shared<CVehicleVelCmd_Holo>(0, 0, 0, 0);
  auto stop = std::make_shared<CVehicleVelCmd_DiffDriven>();
  stop->setToStop();
  return stop;
}

CVehicleVelCmd::Ptr SimulatedRobot::getEmergencyStopCmd() {
  return getStopCmd();
}

Command SimulatedRobot::command() const {
  if (const auto* diff_drive = std::get_if<DiffDrive>(&active_command_))
    return diff_drive_command(*diff_drive);
  if (const auto* holo = std::get_if<Holo>(&active_command_)) return holonomic_command(*holo);
  return {};
}

/// Scales the velocities to within the limits, on the same arc.
Command SimulatedRobot::diff_drive_command(const DiffDrive& diff_drive) const {
  const double scale =
      std::min(limit_scale(diff_drive.v, robot_.max_v), limit_scale(diff_drive.w, robot_.max_w));
  const double v = scale * diff_drive.v;
  return {robot_.forward_only && v < 0 ? 0 : v, scale * diff_drive.w, 0};
}

/// Blends, as MRPT's simulator does, from the velocity at the command to the commanded one during
/// the ramp time. The direction of the commanded one is fixed in the world, while the robot turns
/// to face it.
Command SimulatedRobot::holonomic_command(const Holo& holo) const {
  const double phi = observation_.odometry.phi;
  const double elapsed = now() - holo.begin + control_period_;
  const double ramp = holo.ramp_time;
  const double blend = ramp > 0 ? std::min(1.0, elapsed / ramp) : 1;
  const TPoint2D velocity = rotated(holo.from + (holo.to - holo.from) * blend, -phi);
  const double scale = limit_scale(math::hypot(velocity.x, velocity.y), robot_.max_v);
  const double remaining_angle = mrpt::math::wrapToPi(holo.heading - phi);
  const double turn =
      std::min({std::abs(holo.turn), robot_.max_w, std::abs(remaining_angle) / control_period_});
  const double v = scale * velocity.x;
  return {robot_.forward_only && v < 0 ? 0 : v, std::copysign(turn, remaining_angle),
          scale * velocity.y};
}

}  // namespace slalom
