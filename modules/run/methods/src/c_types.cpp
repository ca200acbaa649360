// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/methods/c_types.h>

namespace slalom {

slalom_robot to_c(const RobotModel& robot, const SensorModel& sensor,
                  std::vector<double>& corners) {
  corners.clear();
  const Footprint footprint = robot.shape();
  for (const auto& corner : footprint.hull()) {
    corners.push_back(corner.x);
    corners.push_back(corner.y);
  }
  slalom_robot result = {};
  result.holonomic = robot.holonomic() ? 1 : 0;
  result.footprint = corners.empty() ? nullptr : corners.data();
  result.footprint_points = corners.size() / 2;
  result.radius = robot.radius;
  result.max_v = robot.max_v;
  result.max_w = robot.max_w;
  result.max_accel_v = robot.max_accel_v;
  result.max_accel_w = robot.max_accel_w;
  result.forward_only = robot.forward_only ? 1 : 0;
  result.rays = sensor.rays;
  result.aperture = sensor.aperture();
  result.max_range = sensor.max_range;
  return result;
}

slalom_task to_c(const NavigationTask& task) {
  slalom_task t = {};
  t.start_x = task.start.x;
  t.start_y = task.start.y;
  t.start_phi = task.start.phi;
  t.goal_x = task.goal.x;
  t.goal_y = task.goal.y;
  t.goal_tolerance = task.goal_tolerance;
  t.control_period = task.control_period;
  t.seed = task.seed;
  return t;
}

slalom_observation to_c(const Observation& observation, std::vector<float>& ranges) {
  const auto& scan = *observation.scan;
  const float* first = scan.getScanSize() > 0 ? &scan.getScanRange(0) : nullptr;
  ranges.assign(first, first + scan.getScanSize());
  slalom_observation o = {};
  o.time = observation.time;
  o.x = observation.odometry.x;
  o.y = observation.odometry.y;
  o.phi = observation.odometry.phi;
  o.v = observation.v;
  o.vy = observation.vy;
  o.w = observation.w;
  o.goal_x = observation.goal_in_robot.x;
  o.goal_y = observation.goal_in_robot.y;
  o.ranges = ranges.data();
  o.rays = ranges.size();
  return o;
}

slalom_map to_c(const KnownMap& map) {
  return {map.resolution, map.origin.x, map.origin.y, map.size_x, map.size_y, map.cells->data()};
}

std::vector<slalom_track> to_c(const std::vector<Track>& tracks) {
  std::vector<slalom_track> converted;
  converted.reserve(tracks.size());
  for (const Track& track : tracks)
    converted.push_back({track.id, track.position.x, track.position.y, track.velocity.x,
                         track.velocity.y, track.radius});
  return converted;
}

}  // namespace slalom
