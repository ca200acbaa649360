#include <slalom/core/error.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/core/bits_math.h>

#include <stdexcept>

namespace slalom {

void RobotModel::visit(OptionVisitor& v) {
  v.option("kinematics", kinematics, "how the robot moves", {"diff_drive", "holonomic"});
  v.option("radius", radius, "m", "radius of the disc footprint", Range::positive());
  v.option("footprint", footprint, "convex polygon instead of the disc: x,y; x,y; ... in m");
  v.option("max_v", max_v, "m/s", "largest speed", Range::positive());
  v.option("max_w", max_w, "rad/s", "largest turning speed", Range::positive());
  v.option("max_accel_v", max_accel_v, "m/s^2", "largest linear acceleration", Range::positive());
  v.option("max_accel_w", max_accel_w, "rad/s^2", "largest angular acceleration",
           Range::positive());
  v.option("forward_only", forward_only, "the robot never drives backwards");
  v.option("min_turning_radius", min_turning_radius, "m",
           "of a diff_drive, as of a car; 0: it turns on the spot", Range::at_least(0));
  v.option("delay", delay, "s", "from a command to when the drives hear it", Range::at_least(0));
  v.option("delay_tau", delay_tau, "s", "time constant of approaching a command; 0: at once",
           Range::at_least(0));
}

Footprint RobotModel::shape() const {
  return footprint.empty() ? Footprint::disc(radius) : Footprint::parse(footprint);
}

RobotModel read_robot_model(const IniFile& ini) {
  auto robot = read_options<RobotModel>(ini, "robot");
  if (robot.footprint.empty()) return robot;
  const std::string where = ini.where("robot", "footprint");
  if (ini.get("robot", "radius"))
    throw usage_error(where, "stands beside a radius", "radius or footprint");
  try {
    robot.radius = robot.shape().enclosing_radius();
  } catch (const std::invalid_argument& expected) {
    throw usage_error(where, "'" + robot.footprint + "' is no footprint", expected.what());
  }
  return robot;
}

void SensorModel::visit(OptionVisitor& v) {
  v.option("aperture_deg", aperture_deg, "deg", "angle between the first and the last ray",
           Range::between(1, 360));
  v.option("rays", rays, "-", "rays of one scan", Range::between(2, 100000));
  v.option("max_range", max_range, "m", "largest range that is measured", Range::positive());
  v.option("noise_sigma", noise_sigma, "m", "standard deviation of a range", Range::at_least(0));
  v.option("dropout_ratio", dropout_ratio, "-", "share of rays that return nothing",
           Range::between(0, 1));
  v.option("quantum", quantum, "m", "ranges are whole multiples of it; 0: not rounded",
           Range::at_least(0));
  v.option("latency", latency, "s", "age of a scan when the method gets it", Range::at_least(0));
}

double SensorModel::aperture() const {
  return mrpt::DEG2RAD(aperture_deg);
}

void OdometryModel::visit(OptionVisitor& v) {
  v.option("distance_sigma", distance_sigma, "m", "standard deviation of the error of 1 m driven",
           Range::at_least(0));
  v.option("turn_sigma", turn_sigma, "rad", "standard deviation of the error of 1 rad turned",
           Range::at_least(0));
}

}  // namespace slalom
