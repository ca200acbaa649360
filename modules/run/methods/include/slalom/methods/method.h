// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/robot_model.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slalom {

/// The map of static obstacles of a run.
struct KnownMap {
  double resolution = 0;                             ///< m, size of a cell
  mrpt::math::TPoint2D origin;                       ///< lower left corner, odometry frame, m
  std::size_t size_x = 0, size_y = 0;                ///< cells
  const std::vector<std::uint8_t>* cells = nullptr;  ///< row by row upwards; 1 occupied, 0 free
};

/// The task of one run: passed to a method before the run.
struct NavigationTask {
  mrpt::math::TPose2D start;      ///< odometry frame, which is the world frame at the start
  mrpt::math::TPoint2D goal;      ///< odometry frame, m
  double goal_tolerance = 0;      ///< m
  double control_period = 0;      ///< s
  std::uint64_t seed = 0;         ///< for methods that draw random numbers
  const KnownMap* map = nullptr;  ///< null unless the method uses_map(); valid during reset()
  std::optional<double> goal_heading = {};  ///< rad, odometry frame; nullopt: any
  double goal_heading_tolerance = 0;        ///< rad
};

/// A mover as a tracker reports it, in the robot frame.
struct Track {
  std::int32_t id = 0;             ///< the same throughout a run
  mrpt::math::TPoint2D position;   ///< of the center, m
  mrpt::math::TVector2D velocity;  ///< over ground, m/s
  double radius = 0;               ///< m
};

/// The input of a method in each control cycle.
struct Observation {
  double time = 0;                     ///< s since the start of the run, simulated
  mrpt::math::TPose2D odometry;        ///< pose, m and rad
  double v = 0, w = 0;                 ///< measured linear and angular velocity, m/s and rad/s
  double vy = 0;                       ///< measured velocity to the left, m/s; 0 for a diff_drive
  mrpt::math::TPoint2D goal_in_robot;  ///< m, robot frame: x forward, y left
  /// The scan of the SensorModel; never null in step().
  const mrpt::obs::CObservation2DRangeScan* scan = nullptr;
  /// The tracks by id; null unless the method uses_tracks().
  const std::vector<Track>* tracks = nullptr;
  /// The scan of each laser with its pose on the robot, in the order of SensorModel::lasers; empty
  /// if there are none.
  std::vector<const mrpt::obs::CObservation2DRangeScan*> lasers = {};
};

/// The velocity command of a method.
struct Command {
  double v = 0;   ///< m/s, forward
  double w = 0;   ///< rad/s, counter-clockwise
  double vy = 0;  ///< m/s, to the left; 0 for a diff_drive
};

/// A numeric parameter of a method with the range in which it is worth tuning.
struct TunableParameter {
  std::string name;
  double default_value = 0, low = 0, high = 1;
  bool log = false;      ///< equal ratios are equally far apart
  bool integer = false;  ///< the values are integers
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

/// The map of a task. Throws MethodError if it has none, as in recorded scans.
const KnownMap& map_of(const NavigationTask& task);

/// The tracks of an observation. Throws MethodError if it has none, as in recorded scans.
const std::vector<Track>& tracks_of(const Observation& observation);

/// The interface of an obstacle avoidance method. One object is used for many runs, one after
/// another: reset(), settle(), then step() once per control cycle. After a reset() the same task
/// and observations must give the same commands.
class Method {
 public:
  virtual ~Method() = default;
  /// Throws Error (Usage) if the method cannot serve runs as it is set up, as when processes that
  /// it launches do not appear. Called before a campaign, on an object that serves no run.
  virtual void check() {}
  virtual void reset(const NavigationTask& task) = 0;
  /// Waits, after reset(), until what answers for the method is ready, as nodes in other processes
  /// are. The first step() is given the same observation. Its time is not that of a cycle.
  virtual void settle(const Observation& /*start*/) {}
  virtual Command step(const Observation& observation) = 0;
  /// Whether the method needs the tracks of movers: its results are marked as privileged. The same
  /// for the life of the object.
  virtual bool uses_tracks() const { return false; }
  /// Whether the method needs the map of static obstacles: privileged, too, and the same for the
  /// life of the object.
  virtual bool uses_map() const { return false; }
  /// Whether step() lasts a control period of the wall clock, however long the method computes: its
  /// computing time is then not known. The same for the life of the object.
  virtual bool is_paced() const { return false; }
  /// The parameters that the method declares for tuning, with their defaults.
  virtual std::vector<TunableParameter> tunable_parameters() const { return {}; }
  /// Figures of the run that depend on the wall clock, by id ("commands_missing", ...), as of
  /// commands that came too late. Called after the run; timing_info() of results describes them.
  virtual std::map<std::string, double> run_figures() const { return {}; }
  /// Whether the method sets parameters of another one: see adaptive_method().
  virtual bool adapts() const { return false; }
  /// In place of step() of a method that adapts(): parameters of the other one from this cycle on,
  /// by name, with values as texts of an .ini.
  virtual std::map<std::string, std::string> adapt(const Observation& /*observation*/) {
    return {};
  }
  /// Changes a parameter from the next step() on. The object then serves no further run. Throws
  /// MethodError for an unknown parameter, an invalid value, and one that cannot change in a run.
  virtual void set_parameter(const std::string& name, const std::string& value);
  /// The run has ended with this outcome ("success", "collision", ...). For information only.
  virtual void finish(const std::string& /*outcome*/) {}
};

}  // namespace slalom
