// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/robot/footprint.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

enum class Kinematics { DiffDrive, Holonomic };
constexpr auto enum_names(Kinematics) {
  return std::array{"diff_drive", "holonomic"};
}

/// The robot: a footprint with bounded velocities and accelerations. The defaults are the robot of
/// "Advances in the Framework for Automatic Evaluation of Obstacle Avoidance Methods": a disc with
/// a differential drive that moves forward only. Section [robot].
struct RobotModel {
  Kinematics kinematics = Kinematics::DiffDrive;
  double radius = 0.25;           ///< m, of the disc; with a polygon, of its enclosing disc
  std::string footprint;          ///< polygon "x,y; x,y; ...", m; empty for the disc
  double max_v = 1.0;             ///< m/s; holonomic: norm of (v, vy)
  double max_w = 1.5;             ///< rad/s
  double max_accel_v = 1.0;       ///< m/s^2; holonomic: norm of the acceleration
  double max_accel_w = 3.0;       ///< rad/s^2
  bool forward_only = true;       ///< v >= 0
  double min_turning_radius = 0;  ///< m, of a diff_drive: |w| <= |v| / radius; 0: rotates in place
  double delay = 0;               ///< s, dead time of commands
  double delay_tau = 0;           ///< s, time constant of a first-order lag; 0: none

  void visit(OptionVisitor& v);
  bool holonomic() const { return kinematics == Kinematics::Holonomic; }
  Footprint shape() const;
  /// The polygon of a robot that rotates in place; none of a disc, nor of a car.
  std::optional<Footprint> turning_polygon() const;
  /// Sets the radius to that of the enclosing disc of a polygon. Throws Error (Usage) at `where`
  /// for a text that is not a polygon around the center.
  void set_radius_of_footprint(const std::string& where);
};

/// Reads section [robot]. Throws Error (Usage), also for a footprint that is not a polygon around
/// the center, or if both footprint and radius are given.
RobotModel read_robot_model(const IniFile& ini);

/// A laser on the robot. Section [laser.NAME], whose keys aperture_deg, rays and max_range default
/// to those of [sensor].
struct LaserModel {
  std::string name;
  double x = 0, y = 0;        ///< m, robot frame
  double yaw = 0;             ///< rad, of the middle ray; robot frame
  bool upside_down = false;   ///< its rays go clockwise
  double aperture_deg = 180;  ///< symmetric about yaw
  int rays = 181;
  double max_range = 8.0;  ///< m
  double range_min = 0;    ///< m; nearer obstacles are not seen
  bool raw = false;        ///< methods get its ranges as if it were at the robot's center

  void visit(OptionVisitor& v);
  double aperture() const;  ///< rad
};

/// The scan that methods get: of a range sensor at the robot's center, oriented along its heading.
/// If the robot has lasers it is merged from their scans. There is no noise by default; each kind
/// of noise, on each laser, uses its own random stream. Section [sensor].
struct SensorModel {
  double aperture_deg = 180;
  int rays = 181;
  double max_range = 8.0;    ///< m
  double noise_sigma = 0;    ///< m, standard deviation of a range
  double dropout_ratio = 0;  ///< fraction of rays without return, as if there were no obstacle
  double quantum = 0;        ///< m, ranges are rounded to multiples of it; 0: not rounded
  double latency = 0;        ///< s, age of a scan when the method receives it

  std::vector<LaserModel> lasers = {};  ///< by name; empty: one at the center, which is the sensor

  void visit(OptionVisitor& v);  ///< all but the lasers
  double aperture() const;       ///< rad
  /// The lasers that measure, or one without a name at the center.
  std::vector<LaserModel> all_lasers() const;
  /// Throws Error (Usage) for lasers of the same or no name, and if one that is `raw` is not the
  /// only one or does not have the aperture, rays and maximum range of the sensor.
  /// `where` is the location of a key of the laser with this name.
  void check_lasers(const std::function<std::string(const std::string& name,
                                                    const std::string& key)>& where) const;
};

/// Reads the sections [sensor] and [laser.*]. Throws Error (Usage).
SensorModel read_sensor_model(const IniFile& ini);

/// The tracker of movers, for methods that declare that they use tracks. It sees all around the
/// robot, also what is hidden behind walls. There is no noise by default. People have the velocity
/// of their last motion, and movers that of their path from now on. Section [tracks].
struct TrackerModel {
  double range = 8.0;         ///< m, to the centers of movers
  double position_sigma = 0;  ///< m, standard deviation of each coordinate
  double velocity_sigma = 0;  ///< m/s, standard deviation of each coordinate
  double dropout_ratio = 0;   ///< fraction of tracks that are missing in a cycle
  double latency = 0;         ///< s, age of the tracks when the method receives them
  bool intention = false;     ///< velocities of people are those of their coming period

  void visit(OptionVisitor& v);
};

/// One line about a valid but suspicious value of [sensor]: an aperture in radians; "" if none.
std::string sensor_warning(const IniFile& ini);

/// The drift of odometry: traveled distances and rotations are measured with a random error.
/// Section [odometry].
struct OdometryModel {
  double distance_sigma = 0;  ///< standard deviation of the error after 1 m, m
  double turn_sigma = 0;      ///< standard deviation of the error after 1 rad, rad

  void visit(OptionVisitor& v);
};

}  // namespace slalom
