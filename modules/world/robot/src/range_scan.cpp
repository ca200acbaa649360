// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/core/placement.h>
#include <slalom/robot/range_scan.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::obs::CObservation2DRangeScan;

/// Angle of ray i in the sensor frame (rad).
double ray_angle(const CObservation2DRangeScan& scan, std::size_t i) {
  const double count = static_cast<double>(scan.getScanSize());
  const double angle = count < 2 ? 0 : scan.aperture * (static_cast<double>(i) / (count - 1) - 0.5);
  return scan.rightToLeft ? angle : -angle;
}

bool is_hit(const CObservation2DRangeScan& scan, std::size_t i) {
  const float range = scan.getScanRange(i);
  return scan.getScanRangeValidity(i) && std::isfinite(range) && range > 0 &&
         (scan.maxRange <= 0 || range < scan.maxRange);
}

/// The pose of a laser, projected to the robot's plane.
Placement mount_of(const mrpt::poses::CPose3D& pose) {
  return {pose.x(), pose.y(), 0, pose.yaw(), pose.pitch(), pose.roll()};
}

bool is_planar(const CObservation2DRangeScan& scan) {
  const double tolerance = mrpt::DEG2RAD(5.0);
  return scan.deltaPitch == 0 && scan.isPlanarScan(tolerance);
}

/// Accumulates points in rays from the robot's center.
class Resampler {
 public:
  explicit Resampler(const SensorModel& sensor)
      : spacing_(sensor.aperture() / (sensor.rays - 1)),
        half_aperture_(0.5 * sensor.aperture()),
        ranges_(static_cast<std::size_t>(sensor.rays), static_cast<float>(sensor.max_range)) {}

  /// Adds a point that covers all rays within `half_angle` of it, at least the closest one, also
  /// across the direction behind the robot.
  void add(const TPoint2D& point, double half_angle) {
    const double range = math::hypot(point.x, point.y);
    const double bearing = math::atan2(point.y, point.x);
    const double half = std::max(half_angle, 0.5 * spacing_);
    for (const double turn : {0.0, -2 * M_PI, 2 * M_PI}) cover(bearing + turn, half, range);
  }

  const std::vector<float>& ranges() const { return ranges_; }

 private:
  void cover(double bearing, double half, double range) {
    const int first =
        static_cast<int>(std::ceil((bearing - half + half_aperture_) / spacing_ - 1e-9));
    const int last =
        static_cast<int>(std::floor((bearing + half + half_aperture_) / spacing_ + 1e-9));
    for (int i = std::max(first, 0); i <= last && i < static_cast<int>(ranges_.size()); ++i) {
      float& current = ranges_[static_cast<std::size_t>(i)];
      current = std::min(current, static_cast<float>(range));
    }
  }

  double spacing_, half_aperture_;
  std::vector<float> ranges_;
};

}  // namespace

std::vector<TPoint2D> scan_points(const CObservation2DRangeScan& scan) {
  std::vector<TPoint2D> points;
  if (!is_planar(scan)) return points;
  const Placement mount = mount_of(scan.sensorPose);
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    if (!is_hit(scan, i)) continue;
    const auto [sine, cosine] = math::sin_cos(ray_angle(scan, i));
    const auto range = static_cast<double>(scan.getScanRange(i));
    const auto point = mount.point({range * cosine, range * sine, 0});
    points.emplace_back(point.x, point.y);
  }
  return points;
}

std::vector<float> merged_ranges(const std::vector<const CObservation2DRangeScan*>& scans,
                                 const SensorModel& sensor) {
  Resampler rays(sensor);
  for (const CObservation2DRangeScan* scan : scans) {
    const double count = static_cast<double>(scan->getScanSize());
    const double half_spacing = count < 2 ? 0 : 0.5 * scan->aperture / (count - 1);
    const TPoint2D laser(scan->sensorPose.x(), scan->sensorPose.y());
    for (const TPoint2D& point : scan_points(*scan)) {
      // The angle that a point covers is different from the robot's center than from the laser.
      const double laser_distance = distance_between(point, laser);
      const double robot_distance = math::hypot(point.x, point.y);
      const double scale = robot_distance > 0 ? laser_distance / robot_distance : 1;
      rays.add(point, std::min(half_spacing * scale, 0.5 * mrpt::DEG2RAD(90.0)));
    }
  }
  return rays.ranges();
}

}  // namespace slalom
