// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/simulation/range_finder.h>

#include <algorithm>
#include <cmath>

namespace slalom {

RangeFinder::RangeFinder(const World& world, const SensorModel& sensor, std::uint64_t seed)
    : caster_(world.ray_caster()),
      sensor_(sensor),
      geometry_{sensor.rays, sensor.aperture(), sensor.max_range},
      movers_(world.scenario().movers(), geometry_),
      noise_(derive_seed(seed, "sensor/noise")),
      dropout_(derive_seed(seed, "sensor/dropout")) {
  const auto count = static_cast<std::size_t>(sensor.rays);
  ranges_.resize(count);
  valid_.resize(count);
  scan_.aperture = static_cast<float>(sensor.aperture());
  scan_.maxRange = static_cast<float>(sensor.max_range);
  scan_.rightToLeft = true;
  scan_.sensorLabel = "range_finder";
}

const mrpt::obs::CObservation2DRangeScan& RangeFinder::sense(const mrpt::math::TPose2D& pose,
                                                             double t,
                                                             mrpt::Clock::time_point time) {
  caster_.cast_scan(pose, geometry_, ranges_.data());
  movers_.add_to(pose, t, ranges_.data());
  if (sensor_.noise_sigma > 0) add_noise();
  if (sensor_.dropout_ratio > 0) drop_rays();
  if (sensor_.quantum > 0) round_ranges();
  const float max_range = scan_.maxRange;  // a copy, which characters cannot alias
  std::transform(ranges_.begin(), ranges_.end(), valid_.begin(),
                 [max_range](float range) { return static_cast<char>(range < max_range); });
  scan_.loadFromVectors(ranges_.size(), ranges_.data(), valid_.data());
  scan_.clear_points();
  scan_.timestamp = time;
  return scan_;
}

void RangeFinder::add_noise() {
  for (float& range : ranges_) {
    const double error = normal(noise_, 0, sensor_.noise_sigma);
    if (range >= scan_.maxRange) continue;  // no return
    range = std::clamp(static_cast<float>(range + error), 0.0F, scan_.maxRange);
  }
}

void RangeFinder::drop_rays() {
  for (float& range : ranges_)
    if (uniform_real(dropout_, 0, 1) < sensor_.dropout_ratio) range = scan_.maxRange;
}

void RangeFinder::round_ranges() {
  for (float& range : ranges_) {
    if (range >= scan_.maxRange) continue;
    const double rounded = std::round(range / sensor_.quantum) * sensor_.quantum;
    range = std::min(static_cast<float>(rounded), scan_.maxRange);
  }
}

}  // namespace slalom
