// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/rawlog/run_scene.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr const char* kRayColor = "#f3d9a4";
constexpr const char* kTrailColor = "#1f5fa8";
constexpr const char* kRobotColor = "#0b2e59";

TPoint2D from(const TPose2D& pose, double angle, double distance) {
  return {pose.x + distance * math::cos(pose.phi + angle),
          pose.y + distance * math::sin(pose.phi + angle)};
}

SceneTrajectory line(Path path, const char* color) {
  SceneTrajectory drawn;
  drawn.path = std::move(path);
  drawn.color = color;
  return drawn;
}

/// A closed outline; discs are approximated by a polygon.
Path outline(const Footprint& shape, const TPose2D& pose) {
  Path corners = shape.corners_at(pose);
  constexpr int kCorners = 32;
  for (int i = 0; shape.is_disc() && i < kCorners; ++i)
    corners.push_back(from(pose, 2 * M_PI * i / kCorners, shape.enclosing_radius()));
  corners.push_back(corners.front());
  return corners;
}

}  // namespace

Path scan_ends(const RecordedRun& run, std::size_t cycle) {
  const auto& scan = *run.cycles[cycle].scan;
  const TPose2D& robot = run.trajectory.samples[cycle].pose;
  const auto& mount = scan.sensorPose;
  const TPoint2D at = compose(robot, {mount.x(), mount.y()});
  const TPose2D laser(at.x, at.y, robot.phi + mount.yaw());
  const double turn = std::abs(mount.roll()) > M_PI / 2 ? -1 : 1;  // upside down: clockwise
  Path ends;
  for (std::size_t ray = 0; ray < scan.getScanSize(); ++ray)
    ends.push_back(
        from(laser, turn * scan.getScanAngle(ray), static_cast<double>(scan.getScanRange(ray))));
  return ends;
}

SceneOptions scene_at(const RecordedRun& run, std::size_t sample, const RobotModel& robot,
                      int max_pixels) {
  const TPose2D& pose = run.trajectory.samples[sample].pose;
  const TPoint2D center{pose.x, pose.y};
  SceneOptions scene;
  scene.max_pixels = max_pixels;
  scene.robot_radius = robot.radius;
  scene.time = run.trajectory.samples[sample].t;
  if (sample < run.cycles.size())
    for (const TPoint2D& end : scan_ends(run, sample))
      scene.trajectories.push_back(line({center, end}, kRayColor));
  Path trail = run.trajectory.path();
  trail.resize(sample + 1);
  scene.trajectories.push_back(line(std::move(trail), kTrailColor));
  const Footprint shape = robot.shape();
  scene.trajectories.push_back(line(outline(shape, pose), kRobotColor));
  scene.trajectories.push_back(
      line({center, from(pose, 0, shape.inscribed_radius())}, kRobotColor));
  return scene;
}

}  // namespace slalom
