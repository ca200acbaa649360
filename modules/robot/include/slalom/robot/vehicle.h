#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/kinematics/CVehicleSimulVirtualBase.h>

#include <deque>
#include <memory>

namespace slalom {

/// Speeds in the robot frame: ahead and to the left in m/s, of turning in rad/s.
struct Velocity {
  double v = 0, w = 0, vy = 0;
};

/// A robot's motion as an MRPT vehicle. A command is heard after the robot's delay, approached with
/// its time constant, within bounded speeds and accelerations. Within one step the speeds change
/// linearly; the pose moves with their means. Its odometry is the true motion.
class Vehicle : public mrpt::kinematics::CVehicleSimulVirtualBase {
 public:
  explicit Vehicle(const RobotModel& robot) : robot_(robot) {}

  /// Stands still at `pose`, odometry equal to it, time 0.
  void start_at(const mrpt::math::TPose2D& pose);

  void command(double v, double w, double vy = 0);  ///< m/s, rad/s, m/s; clamped to the limits
  void advance(double dt);                          ///< one step of dt seconds, undivided
  double v() const { return velocity_.v; }
  double w() const { return velocity_.w; }
  double vy() const { return velocity_.vy; }

 protected:
  const RobotModel& robot() const { return robot_; }

 private:
  /// The nearest command that the robot can take.
  virtual Velocity limited(const Velocity& wanted) const = 0;
  /// `from` changed towards `to` as far as the accelerations allow within dt.
  virtual Velocity approached(const Velocity& from, const Velocity& to, double dt) const = 0;
  /// The pose after driving with constant speeds for dt.
  virtual mrpt::math::TPose2D moved(const mrpt::math::TPose2D& pose, const Velocity& velocity,
                                    double dt) const = 0;

  void internal_simulControlStep(const double dt) override;
  void internal_clear() override;
  /// What the drives have heard of until now, behind the lag of their time constant.
  Velocity heard_command(double dt);

  struct Sent {
    double heard_at;
    Velocity velocity;
  };

  RobotModel robot_;
  Velocity velocity_, heard_;
  std::deque<Sent> on_the_way_;
};

/// The vehicle of the robot's kinematics.
std::unique_ptr<Vehicle> make_vehicle(const RobotModel& robot);

}  // namespace slalom
