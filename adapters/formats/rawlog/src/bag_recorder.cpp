// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"
#include "run_entries.h"

#include <slalom/bags/bag_writer.h>
#include <slalom/bags/ros_encoding.h>
#include <slalom/core/pose.h>
#include <slalom/io/result_file.h>
#include <slalom/methods/goal_turn.h>
#include <slalom/rawlog/bag_recorder.h>
#include <slalom/robot/vehicle.h>

#include <mrpt/math/wrap2pi.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::Clock;
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr const char *kMap = "map", *kOdom = "odom", *kBase = "base_link", *kLaser = "laser";
constexpr double kMoverHeight = 1.7;  // m, of a person

/// ns since 1970 of a time on the clock of recorded runs.
std::int64_t nanoseconds(Clock::time_point time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const auto since_start =
      std::chrono::duration_cast<std::chrono::nanoseconds>(time - logged_start());
  return std::llround(Clock::toDouble(logged_start())) * kSecond + since_start.count();
}

std::int64_t nanoseconds(double seconds) {
  return nanoseconds(logged_time(seconds));
}

RosPose ros_pose(const TPose2D& pose) {
  const auto [s, c] = math::sin_cos(pose.phi / 2);
  return {pose.x, pose.y, 0, 0, 0, s, c};
}

/// Yaw after a roll of pi if it is upside down.
RosPose mount_of(const LaserModel& laser) {
  RosPose mount = ros_pose({laser.x, laser.y, laser.yaw});
  if (laser.upside_down) mount = {mount.x, mount.y, 0, mount.qw, mount.qz, 0, 0};
  return mount;
}

/// The pose of the odometry's frame in the world, such that the robot is where it is.
TPose2D correction(const TPose2D& truth, const TPose2D& odometry) {
  const TPose2D turn{0, 0, mrpt::math::wrapToPi(truth.phi - odometry.phi)};
  const auto turned = compose(turn, {odometry.x, odometry.y});
  return {truth.x - turned.x, truth.y - turned.y, turn.phi};
}

class BagRecorder : public RunObserver {
 public:
  BagRecorder(std::string path, const RunManifest& manifest, const Scenario& scenario,
              const RunSetup& setup)
      : path_(std::move(path)),
        entries_(entries_of(manifest)),
        world_(scenario, setup.simulation.resolution),
        lasers_(setup.sensor.all_lasers()) {}

  void on_start(const NavigationTask& task) override {
    started_ = Clock::now();
    add_task(entries_, task);
    for (const LaserModel& laser : lasers_)
      scans_.push_back(bag_.add_topic(of_laser("/scan", laser), kScanTypes[0]));
    odometry_ = bag_.add_topic("/odom", kOdometryTypes[0]);
    transforms_ = bag_.add_topic("/tf", kTransformTypes[0]);
    commands_ = bag_.add_topic("/cmd_vel", kTwistTypes[1]);
    truth_ = bag_.add_topic("/ground_truth", kOdometryTypes[0]);
    if (!movers().empty()) markers_ = bag_.add_topic("/movers", "visualization_msgs/MarkerArray");
    write_mounts();
    write_map();
    write_goal(task);
  }

  void on_cycle(const Observation& observation, const Command& command,
                const TPose2D& pose) override {
    const RosHeader in_map{nanoseconds(observation.time), kMap};
    const RosHeader in_odom{in_map.stamp, kOdom};
    const Velocity velocity{observation.v, observation.w, observation.vy};
    write_transforms({{in_map, kOdom, ros_pose(correction(pose, observation.odometry))},
                      {in_odom, kBase, ros_pose(observation.odometry)}});
    write_odometry(odometry_, in_odom, observation.odometry, velocity);
    if (observation.lasers.empty()) write_scan(0, *observation.scan, in_map.stamp);
    for (std::size_t i = 0; i < observation.lasers.size(); ++i)
      write_scan(i, *observation.lasers[i], in_map.stamp);
    bag_.write(commands_, in_map.stamp,
               encode(RosTwist{RosHeader{in_map.stamp, kBase}, command.v, command.vy, command.w}));
    write_odometry(truth_, in_map, pose, velocity);
    write_movers(in_map, observation.time);
  }

  void on_end(const SimulationResult& result) override {
    const auto& samples = result.trajectory.samples;
    if (!samples.empty() && !scans_.empty()) {
      const Sample& last = samples.back();
      const RosHeader in_map{nanoseconds(last.t), kMap};
      write_odometry(truth_, in_map, last.pose, {last.v, last.w, last.vy});
      write_movers(in_map, last.t);
    }
    for (const auto& [key, text] : entries_of(result)) entries_[key] = text;
    bag_.add_metadata("slalom", entries_);
    write_file_atomically(path_, bag_.finish());
  }

 private:
  const Movers& movers() const { return world_.scenario().movers(); }

  /// The name of a topic or frame of a laser, which ends with that of one of several.
  std::string of_laser(const std::string& name, const LaserModel& laser) const {
    return lasers_.size() > 1 ? name + "_" + laser.name : name;
  }

  void write_mounts() {
    std::vector<RosTransform> mounts;
    for (const LaserModel& laser : lasers_)
      mounts.push_back({{nanoseconds(0.0), kBase}, of_laser(kLaser, laser), mount_of(laser)});
    bag_.write(bag_.add_topic("/tf_static", kTransformTypes[0]), nanoseconds(0.0), encode(mounts));
  }

  void write_map() {
    const Occupancy& cells = world_.occupancy();
    RosGrid grid;
    grid.header = {nanoseconds(0.0), kMap};
    grid.resolution = cells.resolution();
    grid.width = static_cast<std::uint32_t>(cells.size_x());
    grid.height = static_cast<std::uint32_t>(cells.size_y());
    grid.origin = ros_pose({cells.origin().x, cells.origin().y, 0});
    constexpr std::int8_t kOccupied = 100;
    for (const std::uint8_t cell : cells.cells()) grid.cells.push_back(cell == 0 ? 0 : kOccupied);
    bag_.write(bag_.add_topic("/map", kGridTypes[0]), grid.header.stamp, encode(grid));
  }

  void write_goal(const NavigationTask& task) {
    const RosHeader in_map{nanoseconds(0.0), kMap};
    bag_.write(bag_.add_topic("/goal_pose", kPoseTypes[0]), in_map.stamp,
               encode(RosStampedPose{in_map, ros_pose(goal_pose(task))}));
  }

  void write_transforms(const std::vector<RosTransform>& transforms) {
    bag_.write(transforms_, transforms.front().header.stamp, encode(transforms));
  }

  void write_odometry(std::uint16_t topic, const RosHeader& header, const TPose2D& pose,
                      const Velocity& velocity) {
    bag_.write(
        topic, header.stamp,
        encode(RosOdometry{
            header, kBase, ros_pose(pose), {std::nullopt, velocity.v, velocity.vy, velocity.w}}));
  }

  /// Rays without return are +inf, as REP 117 requires. The stamp is that of the measurement.
  void write_scan(std::size_t laser, const CObservation2DRangeScan& scan, std::int64_t now) {
    const std::size_t rays = scan.getScanSize();
    const double aperture = lasers_[laser].aperture();
    RosScan message;
    message.header = {nanoseconds(logged_start() + (scan.timestamp - started_)),
                      of_laser(kLaser, lasers_[laser])};
    message.angle_min = -aperture / 2;
    message.angle_increment = aperture / static_cast<double>(rays - 1);
    message.range_min = lasers_[laser].range_min;
    message.range_max = lasers_[laser].max_range;
    for (std::size_t i = 0; i < rays; ++i)
      message.ranges.push_back(scan.getScanRangeValidity(i)
                                   ? scan.getScanRange(i)
                                   : std::numeric_limits<float>::infinity());
    bag_.write(scans_[laser], now, encode(message));
  }

  void write_movers(const RosHeader& header, double time) {
    if (movers().empty()) return;
    std::vector<RosMarker> markers;
    for (const Mover& mover : movers()) {
      RosMarker marker{header, mover.id, {}, 2 * mover.radius, kMoverHeight, !mover.present(time)};
      marker.pose = ros_pose({mover.position(time).x, mover.position(time).y, 0});
      marker.pose.z = kMoverHeight / 2;
      markers.push_back(std::move(marker));
    }
    bag_.write(markers_, header.stamp, encode(markers));
  }

  std::string path_;
  Manifest entries_;
  World world_;
  std::vector<LaserModel> lasers_;
  Clock::time_point started_;  ///< depends on previous runs in this process
  BagWriter bag_;
  std::vector<std::uint16_t> scans_;  ///< of lasers_
  std::uint16_t odometry_ = 0, transforms_ = 0, commands_ = 0, truth_ = 0, markers_ = 0;
};

}  // namespace

std::unique_ptr<RunObserver> make_bag_recorder(const std::string& path, const RunManifest& manifest,
                                               const Scenario& scenario, const RunSetup& setup) {
  return std::make_unique<BagRecorder>(path, manifest, scenario, setup);
}

}  // namespace slalom
