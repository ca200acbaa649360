// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/rawlog/open_loop.h>

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

TPoint2D to_robot_frame(const CObservation2DRangeScan& scan, double range, double angle) {
  const auto point = scan.sensorPose.asTPose().composePoint(
      {range * math::cos(angle), range * math::sin(angle), 0});
  return {point.x, point.y};
}

bool is_planar(const CObservation2DRangeScan& scan) {
  const double tolerance = mrpt::DEG2RAD(5.0);
  return scan.deltaPitch == 0 && scan.isPlanarScan(tolerance);
}

/// Accumulates points in the rays of the campaign's sensor.
class Resampler {
 public:
  explicit Resampler(const SensorModel& sensor)
      : spacing_(sensor.aperture() / (sensor.rays - 1)),
        half_aperture_(0.5 * sensor.aperture()),
        ranges_(static_cast<std::size_t>(sensor.rays), static_cast<float>(sensor.max_range)) {}

  /// Adds a point that covers all rays within `half_angle` of it, at least the closest one.
  void add(const TPoint2D& point, double half_angle) {
    const double range = math::hypot(point.x, point.y);
    const double bearing = math::atan2(point.y, point.x);
    const double half = std::max(half_angle, 0.5 * spacing_);
    const int first =
        static_cast<int>(std::ceil((bearing - half + half_aperture_) / spacing_ - 1e-9));
    const int last =
        static_cast<int>(std::floor((bearing + half + half_aperture_) / spacing_ + 1e-9));
    for (int i = std::max(first, 0); i <= last && i < static_cast<int>(ranges_.size()); ++i) {
      float& current = ranges_[static_cast<std::size_t>(i)];
      current = std::min(current, static_cast<float>(range));
    }
  }

  const std::vector<float>& ranges() const { return ranges_; }

 private:
  double spacing_, half_aperture_;
  std::vector<float> ranges_;
};

}  // namespace

std::vector<TPoint2D> scan_points(const CObservation2DRangeScan& scan) {
  std::vector<TPoint2D> points;
  if (!is_planar(scan)) return points;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    if (is_hit(scan, i))
      points.push_back(to_robot_frame(scan, scan.getScanRange(i), ray_angle(scan, i)));
  return points;
}

CObservation2DRangeScan resample_scan(const CObservation2DRangeScan& scan,
                                      const SensorModel& sensor) {
  Resampler rays(sensor);
  const double rays_of_log = static_cast<double>(scan.getScanSize());
  const double half_spacing = rays_of_log < 2 ? 0 : 0.5 * scan.aperture / (rays_of_log - 1);
  const TPoint2D sensor_position = to_robot_frame(scan, 0, 0);
  for (const TPoint2D& point : scan_points(scan)) {
    // The angle that a point covers is different from the robot's center than from the sensor.
    const double sensor_distance = distance_between(point, sensor_position);
    const double robot_distance = math::hypot(point.x, point.y);
    const double scale = robot_distance > 0 ? sensor_distance / robot_distance : 1;
    rays.add(point, std::min(half_spacing * scale, 0.5 * mrpt::DEG2RAD(90.0)));
  }
  CObservation2DRangeScan resampled;
  resampled.aperture = static_cast<float>(sensor.aperture());
  resampled.maxRange = static_cast<float>(sensor.max_range);
  resampled.sensorLabel = "range_finder";
  std::vector<char> valid;
  for (const float range : rays.ranges()) valid.push_back(range < resampled.maxRange ? 1 : 0);
  resampled.loadFromVectors(valid.size(), rays.ranges().data(), valid.data());
  return resampled;
}

}  // namespace slalom
