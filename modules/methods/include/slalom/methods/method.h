#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace slalom {

/// What a method is told once, before a run.
struct Task {
  mrpt::math::TPose2D start;  ///< odometry frame, which is the world frame at the start
  mrpt::math::TPoint2D goal;  ///< odometry frame, m
  double goal_tolerance = 0;  ///< m
  double control_period = 0;  ///< s
  std::uint64_t seed = 0;     ///< for methods that draw random numbers
};

/// What a method is given in each control cycle.
struct Observation {
  double time = 0;                     ///< s since the start of the run, simulated
  mrpt::math::TPose2D odometry;        ///< pose, m and rad
  double v = 0, w = 0;                 ///< measured speeds ahead and of turning, m/s and rad/s
  double vy = 0;                       ///< measured speed to the left, m/s; 0 for a diff_drive
  mrpt::math::TPoint2D goal_in_robot;  ///< m, robot frame: x ahead, y left
  const mrpt::obs::CObservation2DRangeScan* scan = nullptr;  ///< never null in step()
};

/// What a method answers.
struct Command {
  double v = 0;   ///< m/s, ahead
  double w = 0;   ///< rad/s, counter-clockwise
  double vy = 0;  ///< m/s, to the left; a diff_drive takes 0 only
};

/// A method cannot go on; ends its run as method_error with this text.
class MethodError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A method did not answer in time; ends its run as method_deadline with this text.
class MethodTimeout : public MethodError {
 public:
  using MethodError::MethodError;
};

/// The seam for what is evaluated: an obstacle avoidance method. One object serves many runs, one
/// after another: reset(), then step() once per control cycle. Given the same task and observations
/// after a reset() it answers the same commands.
class Method {
 public:
  virtual ~Method() = default;
  virtual void reset(const Task& task) = 0;
  virtual Command step(const Observation& observation) = 0;
  /// The run is over; how, as in results ("success", "collision", ...). Only for information.
  virtual void finish(const std::string& /*outcome*/) {}
};

/// All that an adapter is given to build a method.
struct MethodContext {
  const IniFile& ini;   ///< the campaign's configuration
  std::string section;  ///< "method.NAME"
  RobotModel robot;
  SensorModel sensor;
};

}  // namespace slalom
