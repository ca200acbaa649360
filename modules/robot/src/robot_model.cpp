// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/core/bits_math.h>

namespace slalom {

void RobotModel::visit(OptionVisitor& v) {
  v.option("kinematics", kinematics, "kinematic model");
  v.option("radius", radius, "m", "radius of the disc footprint", Range::positive());
  v.option("footprint", footprint, "convex polygon instead of the disc: x,y; x,y; ... in m");
  v.option("max_v", max_v, "m/s", "maximum linear velocity", Range::positive());
  v.option("max_w", max_w, "rad/s", "maximum angular velocity", Range::positive());
  v.option("max_accel_v", max_accel_v, "m/s^2", "maximum linear acceleration", Range::positive());
  v.option("max_accel_w", max_accel_w, "rad/s^2", "maximum angular acceleration",
           Range::positive());
  v.option("forward_only", forward_only, "the robot never moves backwards");
  v.option("min_turning_radius", min_turning_radius, "m",
           "of a diff_drive, as of a car; 0: it can rotate in place", Range::at_least(0));
  v.option("delay", delay, "s", "dead time of commands", Range::at_least(0));
  v.option("delay_tau", delay_tau, "s", "time constant of the response to commands; 0: none",
           Range::at_least(0));
}

Footprint RobotModel::shape() const {
  return footprint.empty() ? Footprint::disc(radius) : Footprint::parse(footprint);
}

void RobotModel::set_radius_of_footprint(const std::string& where) {
  if (!footprint.empty()) radius = Footprint::parse(footprint, where).enclosing_radius();
}

RobotModel read_robot_model(const IniFile& ini) {
  auto robot = read_options<RobotModel>(ini, "robot");
  const std::string where = ini.where("robot", "footprint");
  if (!robot.footprint.empty() && ini.get("robot", "radius"))
    throw usage_error(where, "radius is given too", "either radius or footprint");
  robot.set_radius_of_footprint(where);
  return robot;
}

void SensorModel::visit(OptionVisitor& v) {
  v.option("aperture_deg", aperture_deg, "deg", "angle between the first and the last ray",
           Range::between(1, 360));
  v.option("rays", rays, "-", "rays of one scan", Range::between(2, 100000));
  v.option("max_range", max_range, "m", "maximum range", Range::positive());
  v.option("noise_sigma", noise_sigma, "m", "standard deviation of a range", Range::at_least(0));
  v.option("dropout_ratio", dropout_ratio, "-", "fraction of rays without return",
           Range::between(0, 1));
  v.option("quantum", quantum, "m", "ranges are rounded to multiples of it; 0: not rounded",
           Range::at_least(0));
  v.option("latency", latency, "s", "age of a scan when the method receives it",
           Range::at_least(0));
}

double SensorModel::aperture() const {
  return mrpt::DEG2RAD(aperture_deg);
}

std::string sensor_warning(const IniFile& ini) {
  constexpr double kFullCircle = 6.3;  // 2 pi, rounded up as in an .ini
  const auto text = ini.get("sensor", "aperture_deg");
  double aperture = 0;
  if (!text || !parse_number(*text, aperture) || aperture > kFullCircle) return "";
  return ini.where("sensor", "aperture_deg") + ": " + *text +
         " degrees looks like radians; expected " + format_fixed(mrpt::RAD2DEG(aperture), 1) +
         " for that angle in degrees";
}

void TrackerModel::visit(OptionVisitor& v) {
  v.option("range", range, "m", "moving obstacles within it have tracks", Range::positive());
  v.option("position_sigma", position_sigma, "m", "standard deviation of each coordinate",
           Range::at_least(0));
  v.option("velocity_sigma", velocity_sigma, "m/s", "standard deviation of each coordinate",
           Range::at_least(0));
  v.option("dropout_ratio", dropout_ratio, "-", "fraction of tracks that are missing in a cycle",
           Range::between(0, 1));
  v.option("latency", latency, "s", "age of the tracks when the method receives them",
           Range::at_least(0));
}

void OdometryModel::visit(OptionVisitor& v) {
  v.option("distance_sigma", distance_sigma, "m", "standard deviation of the error after 1 m",
           Range::at_least(0));
  v.option("turn_sigma", turn_sigma, "rad", "standard deviation of the error after 1 rad",
           Range::at_least(0));
}

}  // namespace slalom
