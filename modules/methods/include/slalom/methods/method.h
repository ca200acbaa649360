#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace slalom {

/// The task of one run: passed to a method before the run.
struct NavigationTask {
  mrpt::math::TPose2D start;  ///< odometry frame, which is the world frame at the start
  mrpt::math::TPoint2D goal;  ///< odometry frame, m
  double goal_tolerance = 0;  ///< m
  double control_period = 0;  ///< s
  std::uint64_t seed = 0;     ///< for methods that draw random numbers
};

/// The input of a method in each control cycle.
struct Observation {
  double time = 0;                     ///< s since the start of the run, simulated
  mrpt::math::TPose2D odometry;        ///< pose, m and rad
  double v = 0, w = 0;                 ///< measured linear and angular velocity, m/s and rad/s
  double vy = 0;                       ///< measured velocity to the left, m/s; 0 for a diff_drive
  mrpt::math::TPoint2D goal_in_robot;  ///< m, robot frame: x forward, y left
  const mrpt::obs::CObservation2DRangeScan* scan = nullptr;  ///< never null in step()
};

/// The velocity command of a method.
struct Command {
  double v = 0;   ///< m/s, forward
  double w = 0;   ///< rad/s, counter-clockwise
  double vy = 0;  ///< m/s, to the left; 0 for a diff_drive
};

/// An error of a method; ends its run as method_error with this text.
class MethodError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A method did not respond in time; ends its run as method_deadline with this text.
class MethodTimeout : public MethodError {
 public:
  using MethodError::MethodError;
};

/// The interface of an obstacle avoidance method. One object is used for many runs, one after
/// another: reset(), then step() once per control cycle. After a reset() the same task and
/// observations must give the same commands.
class Method {
 public:
  virtual ~Method() = default;
  virtual void reset(const NavigationTask& task) = 0;
  virtual Command step(const Observation& observation) = 0;
  /// The run has ended with this outcome ("success", "collision", ...). For information only.
  virtual void finish(const std::string& /*outcome*/) {}
};

}  // namespace slalom
