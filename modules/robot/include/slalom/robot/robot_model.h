#pragma once

#include <slalom/core/options.h>
#include <slalom/robot/footprint.h>

namespace slalom {

/// The robot: a footprint with bounded speeds and accelerations. Defaults are the paper's robot: a
/// disc with a differential drive that moves forward only. Section [robot].
struct RobotModel {
  std::string kinematics = "diff_drive";  ///< or holonomic
  double radius = 0.25;           ///< m, of the disc; with a polygon, of the disc that encloses it
  std::string footprint;          ///< convex polygon "x,y; x,y; ...", m; empty for the disc
  double max_v = 1.0;             ///< m/s; holonomic: of the velocity's length
  double max_w = 1.5;             ///< rad/s
  double max_accel_v = 1.0;       ///< m/s^2; holonomic: of the velocity's change
  double max_accel_w = 3.0;       ///< rad/s^2
  bool forward_only = true;       ///< v >= 0
  double min_turning_radius = 0;  ///< m, of a diff_drive: |w| <= |v| / radius; 0: turns on the spot
  double delay = 0;               ///< s from a command to the moment in which the drives hear it
  double delay_tau = 0;  ///< s, time constant with which speeds approach a command; 0: at once

  void visit(OptionVisitor& v);
  bool holonomic() const { return kinematics == "holonomic"; }
  Footprint shape() const;
};

/// Reads section [robot]. Throws Error (Usage), also for a footprint that is no convex polygon
/// about the centre, or beside a radius.
RobotModel read_robot_model(const IniFile& ini);

/// The range sensor, at the robot's centre, looking along its heading. Section [sensor]. Without
/// noise by default; each kind of noise draws from a random stream of its own.
struct SensorModel {
  double aperture_deg = 180;
  int rays = 181;
  double max_range = 8.0;    ///< m
  double noise_sigma = 0;    ///< m, standard deviation of a range
  double dropout_ratio = 0;  ///< share of rays that return nothing, as if there were no obstacle
  double quantum = 0;        ///< m, ranges are whole multiples of it; 0: not rounded
  double latency = 0;        ///< s, age of a scan when the method gets it

  void visit(OptionVisitor& v);
  double aperture() const;  ///< rad
};

/// How odometry drifts from the truth: each driven distance and turn is measured with a relative
/// error. Section [odometry].
struct OdometryModel {
  double distance_sigma = 0;  ///< standard deviation of the error of 1 m driven, m
  double turn_sigma = 0;      ///< standard deviation of the error of 1 rad turned, rad

  void visit(OptionVisitor& v);
};

}  // namespace slalom
