#include "sectors.h"
#include "simulated_robot.h"

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
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// The share by which a speed must be scaled to be within `limit`.
double share_within(double speed, double limit) {
  return std::abs(speed) > limit ? limit / std::abs(speed) : 1;
}

/// Multiples of 2^-20 s: their differences are exact.
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
  in_force_ = Stop{};
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
  // What is not cleared here piles up cycle by cycle.
  obstacles.clear();
  if (observation_.scan == nullptr) return false;
  const auto height = static_cast<float>(obstacle_height_);
  for (const TPoint2D& point : obstacle_points(*observation_.scan))
    obstacles.insertPoint(static_cast<float>(point.x), static_cast<float>(point.y), height);
  timestamp = observation_.scan->timestamp;
  return true;
}

bool SimulatedRobot::changeSpeeds(const CVehicleVelCmd& command) {
  if (const auto* wheels = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&command)) {
    in_force_ = Wheels{wheels->lin_vel, wheels->ang_vel};
    return true;
  }
  const auto* holo = dynamic_cast<const CVehicleVelCmd_Holo*>(&command);
  if (holo == nullptr || !robot_.holonomic())
    throw MethodError(std::string("the navigator commands a ") +
                      command.GetRuntimeClass()->className + ", not for a " + robot_.kinematics);
  const double heading = observation_.odometry.phi + holo->dir_local;
  in_force_ = Holo{
      holo->ramp_time, holo->rot_speed, now(), world_velocity(), rotated({holo->vel, 0}, heading),
      heading};
  return true;
}

bool SimulatedRobot::stop(bool) {
  in_force_ = Stop{};
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
  if (const auto* wheels = std::get_if<Wheels>(&in_force_)) return wheel_command(*wheels);
  if (const auto* holo = std::get_if<Holo>(&in_force_)) return holonomic_command(*holo);
  return {};
}

/// Within the limits, slower on the same arc.
Command SimulatedRobot::wheel_command(const Wheels& wheels) const {
  const double share =
      std::min(share_within(wheels.v, robot_.max_v), share_within(wheels.w, robot_.max_w));
  const double v = share * wheels.v;
  return {robot_.forward_only && v < 0 ? 0 : v, share * wheels.w, 0};
}

/// As in MRPT's own simulator: within the ramp time the velocity blends from that at the command to
/// the wanted one, whose direction is fixed in the world; meanwhile the robot turns to face it.
Command SimulatedRobot::holonomic_command(const Holo& holo) const {
  const double phi = observation_.odometry.phi;
  const double passed = now() - holo.begin + control_period_;
  const double ramp = holo.ramp_time;
  const double blend = ramp > 0 ? std::min(1.0, passed / ramp) : 1;
  const TPoint2D velocity = rotated(holo.from + (holo.to - holo.from) * blend, -phi);
  const double share = share_within(std::hypot(velocity.x, velocity.y), robot_.max_v);
  const double left = mrpt::math::wrapToPi(holo.heading - phi);
  const double turn =
      std::min({std::abs(holo.turn), robot_.max_w, std::abs(left) / control_period_});
  const double v = share * velocity.x;
  return {robot_.forward_only && v < 0 ? 0 : v, std::copysign(turn, left), share * velocity.y};
}

}  // namespace slalom
