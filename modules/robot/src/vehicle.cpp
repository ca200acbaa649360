#include <slalom/robot/diff_drive.h>
#include <slalom/robot/holonomic_drive.h>
#include <slalom/robot/vehicle.h>

#include <cmath>

namespace slalom {
namespace {

/// Times are sums of steps; this much (s) absorbs their rounding.
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
  on_the_way_.push_back({m_time + robot_.delay, limited({v, w, vy})});
}

void Vehicle::advance(double dt) {
  internal_simulControlStep(dt);
  m_time += dt;
}

Velocity Vehicle::heard_command(double dt) {
  while (!on_the_way_.empty() && on_the_way_.front().heard_at <= m_time + kTimeTolerance) {
    heard_ = on_the_way_.front().velocity;
    on_the_way_.pop_front();
  }
  if (!(robot_.delay_tau > 0)) return heard_;
  const double share = 1 - std::exp(-dt / robot_.delay_tau);
  return {velocity_.v + share * (heard_.v - velocity_.v),
          velocity_.w + share * (heard_.w - velocity_.w),
          velocity_.vy + share * (heard_.vy - velocity_.vy)};
}

void Vehicle::internal_simulControlStep(const double dt) {
  const Velocity before = velocity_;
  velocity_ = approached(before, heard_command(dt), dt);
  m_GT_pose = moved(m_GT_pose, mean(before, velocity_), dt);
  const double c = std::cos(m_GT_pose.phi), s = std::sin(m_GT_pose.phi);
  m_GT_vel = {velocity_.v * c - velocity_.vy * s, velocity_.v * s + velocity_.vy * c, velocity_.w};
  m_odometry = m_GT_pose;
  m_odometric_vel = m_GT_vel;
}

void Vehicle::internal_clear() {
  velocity_ = heard_ = {};
  on_the_way_.clear();
}

std::unique_ptr<Vehicle> make_vehicle(const RobotModel& robot) {
  if (robot.holonomic()) return std::make_unique<HolonomicDrive>(robot);
  return std::make_unique<DiffDrive>(robot);
}

}  // namespace slalom
