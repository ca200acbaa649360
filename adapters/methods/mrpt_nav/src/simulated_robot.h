// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>

#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <variant>

namespace slalom {

/// The robot interface of MRPT's navigators: observations in, velocity commands out. Its navigation
/// timer shows simulated time and is monotonic, also between runs. Time differences are exact, so
/// they do not depend on the start time of a run.
class SimulatedRobot : public mrpt::nav::CRobot2NavInterface {
 public:
  /// Obstacle points have z = `obstacle_height` (m): navigators may ignore low or high points.
  SimulatedRobot(const RobotModel& robot, double obstacle_height);

  /// Navigation timer at the start of the first run, s.
  static constexpr double kTimerBegin = 2;

  void start_run(double control_period);  ///< robot at rest, no observation yet
  /// For a new navigator: sets the timer to kTimerBegin.
  void restart_timer();
  void observe(const Observation& observation);  ///< must stay valid until the next call
  /// Returns the active command for the next control period, within the robot's limits.
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
  // Plain structs: MRPT's commands cannot be copied (their base calls a pure virtual function).
  struct Stop {};
  struct DiffDrive {
    double v = 0, w = 0;
  };
  /// A holonomic command with the state of the robot at that time (world frame).
  struct Holo {
    double ramp_time = 0, turn = 0;  ///< s, rad/s
    double begin = 0;                ///< now() at the command, s
    mrpt::math::TPoint2D from, to;   ///< velocity, m/s
    double heading = 0;              ///< target heading, rad
  };

  double now() const;
  mrpt::math::TPoint2D world_velocity() const;
  Command diff_drive_command(const DiffDrive& diff_drive) const;
  Command holonomic_command(const Holo& holo) const;

  RobotModel robot_;
  double obstacle_height_;
  double control_period_ = 0;
  double run_begin_ = kTimerBegin;  ///< start of the run on the timer, whole seconds
  double timer_zero_ = 0;           ///< see resetNavigationTimer()
  Observation observation_;
  std::variant<Stop, DiffDrive, Holo> active_command_;
};

}  // namespace slalom
