#include "range_finder.h"

namespace slalom {

RangeFinder::RangeFinder(const World& world, const SensorModel& sensor)
    : caster_(world.ray_caster()), geometry_{sensor.rays, sensor.aperture(), sensor.max_range} {
  const auto count = static_cast<std::size_t>(sensor.rays);
  ranges_.resize(count);
  valid_.resize(count);
  scan_.aperture = static_cast<float>(sensor.aperture());
  scan_.maxRange = static_cast<float>(sensor.max_range);
  scan_.rightToLeft = true;
  scan_.sensorLabel = "range_finder";
}

const mrpt::obs::CObservation2DRangeScan& RangeFinder::sense(const mrpt::math::TPose2D& pose,
                                                             mrpt::Clock::time_point time) {
  caster_.cast_scan(pose, geometry_, ranges_.data());
  for (std::size_t i = 0; i < ranges_.size(); ++i) valid_[i] = ranges_[i] < scan_.maxRange ? 1 : 0;
  scan_.loadFromVectors(ranges_.size(), ranges_.data(), valid_.data());
  scan_.forget_points();
  scan_.timestamp = time;
  return scan_;
}

}  // namespace slalom
