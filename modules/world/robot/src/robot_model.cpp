// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>

namespace slalom {
namespace {

LaserModel like_sensor(const SensorModel& sensor) {
  LaserModel laser;
  laser.aperture_deg = sensor.aperture_deg;
  laser.rays = sensor.rays;
  laser.max_range = sensor.max_range;
  return laser;
}

}  // namespace

void RobotModel::visit(OptionVisitor& v) {
  v.option("kinematics", kinematics, "kinematic model");
  v.option("radius", radius, "m", "radius of the disc footprint", Range::positive());
  v.option("footprint", footprint, "polygon instead of the disc: x,y; x,y; ... in m");
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

std::optional<Footprint> RobotModel::turning_polygon() const {
  if (footprint.empty() || min_turning_radius > 0) return std::nullopt;
  return shape();
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

void LaserModel::visit(OptionVisitor& v) {
  constexpr double kMaxOffset = 100;  // m
  v.option("x", x, "m", "forward of the robot's center", Range::between(-kMaxOffset, kMaxOffset));
  v.option("y", y, "m", "to its left", Range::between(-kMaxOffset, kMaxOffset));
  v.option("yaw", yaw, "rad", "direction of the middle ray, counter-clockwise",
           Range::between(-6.3, 6.3));
  v.option("upside_down", upside_down, "mounted upside down: its rays go clockwise");
  v.option("aperture_deg", aperture_deg, "deg",
           "angle between the first and the last ray; default: that of [sensor]",
           Range::between(1, 360));
  v.option("rays", rays, "-", "rays of one scan; default: those of [sensor]",
           Range::between(2, 100000));
  v.option("max_range", max_range, "m", "maximum range; default: that of [sensor]",
           Range::positive());
  v.option("range_min", range_min, "m", "nearer obstacles are not seen", Range::at_least(0));
  v.option("raw", raw,
           "methods get its ranges as it measures them, as if it were at the robot's center");
}

double LaserModel::aperture() const {
  return mrpt::DEG2RAD(aperture_deg);
}

std::vector<LaserModel> SensorModel::all_lasers() const {
  return lasers.empty() ? std::vector<LaserModel>{like_sensor(*this)} : lasers;
}

void SensorModel::check_lasers(
    const std::function<std::string(const std::string& name, const std::string& key)>& where)
    const {
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    const LaserModel& laser = lasers[i];
    const auto fail = [&](const char* key, const std::string& problem,
                          const std::string& expected) {
      throw usage_error(where(laser.name, key), problem, expected);
    };
    const bool plain =
        laser.name.find_first_not_of(
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    if (!plain || laser.name.empty())
      fail("", "invalid name '" + laser.name + "'", "letters, digits and '_'");
    if (std::any_of(lasers.begin(), lasers.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const LaserModel& other) { return other.name == laser.name; }))
      fail("", "two lasers have the name '" + laser.name + "'", "one");
    if (laser.range_min >= laser.max_range)
      fail("range_min", format_number(laser.range_min) + " m is not valid",
           "less than max_range, " + format_number(laser.max_range) + " m");
    if (!laser.raw) continue;
    if (lasers.size() > 1)
      fail("raw", "the robot has " + count_text(lasers.size(), "laser"), "one");
    if (laser.aperture_deg != aperture_deg || laser.rays != rays || laser.max_range != max_range)
      fail("raw", "the laser has other rays than [sensor]", "its aperture_deg, rays and max_range");
  }
}

SensorModel read_sensor_model(const IniFile& ini) {
  auto sensor = read_options<SensorModel>(ini, "sensor");
  const std::string prefix = "laser.";
  for (const std::string& section : ini.sections()) {
    if (!starts_with(section, prefix)) continue;
    LaserModel laser = like_sensor(sensor);
    laser.name = section.substr(prefix.size());
    sensor.lasers.push_back(read_options(ini, section, laser));
  }
  std::sort(sensor.lasers.begin(), sensor.lasers.end(),
            [](const LaserModel& a, const LaserModel& b) { return a.name < b.name; });
  sensor.check_lasers([&](const std::string& name, const std::string& key) {
    return ini.where(prefix + name, key);
  });
  return sensor;
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
  v.option("intention", intention,
           "velocities of people are those just chosen for the coming period, not of the last one");
}

void OdometryModel::visit(OptionVisitor& v) {
  v.option("distance_sigma", distance_sigma, "m", "standard deviation of the error after 1 m",
           Range::at_least(0));
  v.option("turn_sigma", turn_sigma, "rad", "standard deviation of the error after 1 rad",
           Range::at_least(0));
}

}  // namespace slalom
