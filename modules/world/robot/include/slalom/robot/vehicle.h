// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/kinematics/CVehicleSimulVirtualBase.h>

#include <deque>
#include <memory>

namespace slalom {

/// Velocity in the robot frame: forward (v) and to the left (vy) in m/s, angular (w) in rad/s.
struct Velocity {
  double v = 0, w = 0, vy = 0;
};

/// The motion model of a robot as an MRPT vehicle. A command takes effect after the robot's delay,
/// is filtered with its time constant, and is limited in velocity and acceleration. Within one step
/// the velocities change linearly; the pose is integrated with their means. The odometry is the
/// true motion.
class Vehicle : public mrpt::kinematics::CVehicleSimulVirtualBase {
 public:
  explicit Vehicle(const RobotModel& robot) : robot_(robot) {}

  /// Resets to `pose` at rest, odometry equal to it, time 0.
  void start_at(const mrpt::math::TPose2D& pose);

  /// m/s, rad/s, m/s; clamped to the limits.
  void command(double v, double w, double vy = 0);
  /// One integration step of dt seconds. MRPT's velocities in world coordinates (getCurrentGTVel())
  /// follow simulateOneTimeStep() only, since they take as long as the step itself.
  void advance(double dt);
  double v() const { return velocity_.v; }
  double w() const { return velocity_.w; }
  double vy() const { return velocity_.vy; }
  /// Distance traveled in the last step, along its arc (m).
  double step_length() const { return step_length_; }

 protected:
  const RobotModel& robot() const { return robot_; }

 private:
  /// The command within the velocity limits.
  virtual Velocity clamp_to_limits(const Velocity& target) const = 0;
  /// `from` changed towards `to` as far as the acceleration limits allow within dt.
  virtual Velocity apply_acceleration_limits(const Velocity& from, const Velocity& to,
                                             double dt) const = 0;
  /// The pose after moving with constant velocity for dt.
  virtual mrpt::math::TPose2D integrate(const mrpt::math::TPose2D& pose, const Velocity& velocity,
                                        double dt) const = 0;

  void move(double dt);
  void internal_simulControlStep(const double dt) override;
  void internal_clear() override;
  /// The command in effect after dead time and first-order lag.
  Velocity delayed_command(double dt);

  struct PendingCommand {
    double effective_at;
    Velocity velocity;
  };

  RobotModel robot_;
  Velocity velocity_, effective_command_;
  double step_length_ = 0;
  std::deque<PendingCommand> pending_commands_;
};

/// The vehicle of the robot's kinematics.
std::unique_ptr<Vehicle> make_vehicle(const RobotModel& robot);

}  // namespace slalom
