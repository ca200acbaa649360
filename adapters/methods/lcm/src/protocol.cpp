// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/lcm/protocol.h>

#include <mrpt/core/bits_math.h>

#include <cmath>

namespace slalom {
namespace {

/// Returns degrees that convert to exactly these radians, searching the adjacent doubles.
double degrees_of(double radians) {
  SensorModel sensor;
  const double approximate = mrpt::RAD2DEG(radians);
  double candidate = approximate;
  for (int i = 0; i < 4; ++i) candidate = std::nextafter(candidate, -HUGE_VAL);
  for (int i = 0; i < 9; ++i, candidate = std::nextafter(candidate, HUGE_VAL)) {
    sensor.aperture_deg = candidate;
    if (sensor.aperture() == radians) return candidate;
  }
  return approximate;
}

/// Returns "x,y; x,y"; each number is read back as the same bits.
std::string footprint_text(const hello_t& hello) {
  std::string text;
  for (std::size_t i = 0; i < hello.footprint_x.size(); ++i)
    text += (i == 0 ? "" : "; ") + format_number(hello.footprint_x[i]) + "," +
            format_number(hello.footprint_y[i]);
  return text;
}

}  // namespace

LcmChannels::LcmChannels(const std::string& prefix)
    : hello(prefix + "_HELLO"),
      goal_heading(prefix + "_GOAL_HEADING"),
      run_start(prefix + "_RUN_START"),
      observation(prefix + "_OBSERVATION"),
      run_end(prefix + "_RUN_END"),
      ready(prefix + "_READY"),
      command(prefix + "_COMMAND"),
      error(prefix + "_ERROR") {}

bool can_receive(lcm::LCM& lcm) {
  if (!lcm.good()) return false;
  const auto ignore = [](const lcm_recv_buf_t*, const char*, void*) {};
  lcm_subscription_t* subscription =
      lcm_subscribe(lcm.getUnderlyingLCM(), "SLALOM_PROBE", ignore, nullptr);
  return subscription != nullptr && lcm_unsubscribe(lcm.getUnderlyingLCM(), subscription) == 0;
}

hello_t make_hello(const std::string& method, const RobotModel& robot, const SensorModel& sensor,
                   const MethodSettings& settings) {
  hello_t hello = {};
  hello.protocol_version = kLcmProtocolVersion;
  hello.method = method;
  hello.holonomic = robot.holonomic() ? 1 : 0;
  hello.forward_only = robot.forward_only ? 1 : 0;
  hello.radius = robot.radius;
  const Footprint footprint = robot.shape();
  for (const auto& corner : footprint.hull()) {
    hello.footprint_x.push_back(corner.x);
    hello.footprint_y.push_back(corner.y);
  }
  hello.footprint_points = static_cast<std::int32_t>(hello.footprint_x.size());
  hello.max_v = robot.max_v;
  hello.max_w = robot.max_w;
  hello.max_accel_v = robot.max_accel_v;
  hello.max_accel_w = robot.max_accel_w;
  hello.rays = sensor.rays;
  hello.aperture = sensor.aperture();
  hello.max_range = sensor.max_range;
  for (const auto& [key, value] : settings) {
    hello.keys.push_back(key);
    hello.values.push_back(value);
  }
  hello.setting_count = static_cast<std::int32_t>(settings.size());
  return hello;
}

goal_heading_t make_goal_heading(std::int64_t run_id, const NavigationTask& task) {
  goal_heading_t message = {};
  message.run_id = run_id;
  message.heading = task.goal_heading.value();
  message.tolerance = task.goal_heading_tolerance;
  return message;
}

run_start_t make_run_start(std::int64_t run_id, const NavigationTask& task) {
  run_start_t message = {};
  message.run_id = run_id;
  message.start_x = task.start.x;
  message.start_y = task.start.y;
  message.start_phi = task.start.phi;
  message.goal_x = task.goal.x;
  message.goal_y = task.goal.y;
  message.goal_tolerance = task.goal_tolerance;
  message.control_period = task.control_period;
  message.seed = static_cast<std::int64_t>(task.seed);
  return message;
}

void fill_observation(const Observation& observation, observation_t& message) {
  const auto& scan = *observation.scan;
  message.rays = static_cast<std::int32_t>(scan.getScanSize());
  message.time = observation.time;
  message.x = observation.odometry.x;
  message.y = observation.odometry.y;
  message.phi = observation.odometry.phi;
  message.v = observation.v;
  message.vy = observation.vy;
  message.w = observation.w;
  message.goal_x = observation.goal_in_robot.x;
  message.goal_y = observation.goal_in_robot.y;
  if (scan.getScanSize() == 0) return message.ranges.clear();
  const float* first = &scan.getScanRange(0);
  message.ranges.assign(first, first + scan.getScanSize());
}

Command command_of(const command_t& message) {
  return {message.v, message.w, message.vy};
}

RobotModel robot_of(const hello_t& hello) {
  RobotModel robot;
  robot.kinematics = hello.holonomic != 0 ? Kinematics::Holonomic : Kinematics::DiffDrive;
  robot.radius = hello.radius;
  robot.footprint = footprint_text(hello);
  robot.max_v = hello.max_v;
  robot.max_w = hello.max_w;
  robot.max_accel_v = hello.max_accel_v;
  robot.max_accel_w = hello.max_accel_w;
  robot.forward_only = hello.forward_only != 0;
  return robot;
}

SensorModel sensor_of(const hello_t& hello) {
  SensorModel sensor;
  sensor.rays = hello.rays;
  sensor.aperture_deg = degrees_of(hello.aperture);
  sensor.max_range = hello.max_range;
  return sensor;
}

MethodSettings settings_of(const hello_t& hello) {
  MethodSettings settings;
  for (std::size_t i = 0; i < hello.keys.size(); ++i) settings[hello.keys[i]] = hello.values[i];
  return settings;
}

NavigationTask task_of(const run_start_t& message) {
  NavigationTask task;
  task.start = {message.start_x, message.start_y, message.start_phi};
  task.goal = {message.goal_x, message.goal_y};
  task.goal_tolerance = message.goal_tolerance;
  task.control_period = message.control_period;
  task.seed = static_cast<std::uint64_t>(message.seed);
  return task;
}

void ReceivedScan::set_ranges(const std::vector<float>& ranges) {
  valid_.resize(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) valid_[i] = ranges[i] < maxRange ? 1 : 0;
  loadFromVectors(ranges.size(), ranges.data(), valid_.data());
  m_cachedMap.reset();
}

Observation observation_of(const observation_t& message, const SensorModel& sensor,
                           ReceivedScan& scan) {
  scan.aperture = static_cast<float>(sensor.aperture());
  scan.maxRange = static_cast<float>(sensor.max_range);
  scan.rightToLeft = true;
  scan.set_ranges(message.ranges);
  Observation observation;
  observation.time = message.time;
  observation.odometry = {message.x, message.y, message.phi};
  observation.v = message.v;
  observation.vy = message.vy;
  observation.w = message.w;
  observation.goal_in_robot = {message.goal_x, message.goal_y};
  observation.scan = &scan;
  return observation;
}

}  // namespace slalom
