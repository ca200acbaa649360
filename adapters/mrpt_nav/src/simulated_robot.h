#pragma once

#include <slalom/methods/method.h>

#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <variant>

namespace slalom {

/// The robot as MRPT's navigators see it: observations in, velocity commands out. Its navigation
/// timer is simulated time and never runs backwards, not even between runs; differences of it are
/// exact, so that they do not depend on when a run begins.
class SimulatedRobot : public mrpt::nav::CRobot2NavInterface {
 public:
  /// Obstacles are told at `obstacle_height` (m): navigators may ignore what is too low or high.
  SimulatedRobot(const RobotModel& robot, double obstacle_height);

  /// What the navigation timer shows when the first run begins, s.
  static constexpr double kTimerBegin = 2;

  void start_run(double control_period);  ///< stands still; knows no observation
  /// For a new navigator: the timer shows kTimerBegin again.
  void restart_timer();
  void observe(const Observation& observation);  ///< valid until the next one
  /// What the command in force means for the coming control period, within the robot's limits.
  Command command() const;

  bool getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity,
                               mrpt::system::TTimeStamp& timestamp, mrpt::math::TPose2D& odometry,
                               std::string& frame_id) override;
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override;
  bool changeSpeedsNOP() override { return true; }
  bool stop(bool is_emergency) override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override;
  mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override;
  bool senseObstacles(mrpt::maps::CSimplePointsMap& obstacles,
                      mrpt::system::TTimeStamp& timestamp) override;
  double getNavigationTime() override;
  void resetNavigationTimer() override { timer_zero_ = now(); }

 private:
  // Plain numbers: MRPT's commands cannot be copied (their base calls a pure virtual function).
  struct Stop {};
  struct Wheels {
    double v = 0, w = 0;
  };
  /// A holonomic command with the state of the robot when it was given (world frame).
  struct Holo {
    double ramp_time = 0, turn = 0;  ///< s, rad/s
    double begin = 0;                ///< s, of now()
    mrpt::math::TPoint2D from, to;   ///< velocity, m/s
    double heading = 0;              ///< rad, where it turns to
  };

  double now() const;
  mrpt::math::TPoint2D world_velocity() const;
  Command wheel_command(const Wheels& wheels) const;
  Command holonomic_command(const Holo& holo) const;

  RobotModel robot_;
  double obstacle_height_;
  double control_period_ = 0;
  double run_begin_ = kTimerBegin;  ///< of the navigation timer, whole seconds
  double timer_zero_ = 0;           ///< see resetNavigationTimer()
  Observation observation_;
  std::variant<Stop, Wheels, Holo> in_force_;
};

}  // namespace slalom
