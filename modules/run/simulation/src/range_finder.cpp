// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/pose.h>
#include <slalom/core/random.h>
#include <slalom/robot/range_scan.h>
#include <slalom/simulation/mover_scan.h>
#include <slalom/simulation/range_finder.h>

#include <algorithm>
#include <cmath>

namespace slalom {
using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

/// MRPT caches the points of a scan (buildAuxPointsMap) even if the ranges change; a reused scan
/// must clear them, or methods would get outdated points.
class RangeFinder::ReusedScan : public CObservation2DRangeScan {
 public:
  ReusedScan(const std::string& label, double aperture_rad, double max_range) {
    aperture = static_cast<float>(aperture_rad);
    maxRange = static_cast<float>(max_range);
    rightToLeft = true;
    sensorLabel = label;
  }

  /// loadFromVectors() calls functions for each ray.
  void fill(const std::vector<float>& ranges, mrpt::Clock::time_point time) {
    if (getScanSize() != ranges.size()) {
      resizeScanAndAssign(ranges.size(), 0, true);
      valid_.assign(ranges.size(), 1);
    }
    const float max_range = maxRange;  // a copy, which characters cannot alias
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const auto valid = static_cast<char>(ranges[i] < max_range);
      if (valid == valid_[i]) continue;
      setScanRangeValidity(i, valid != 0);
      valid_[i] = valid;
    }
    if (!ranges.empty()) std::copy(ranges.begin(), ranges.end(), &getScanRange(0));
    m_cachedMap.reset();
    timestamp = time;
  }

 private:
  std::vector<char> valid_;
};

class RangeFinder::Laser {
 public:
  /// `label` is that of the scan if the laser has no name.
  Laser(const World& world, const Movers& movers, const SensorModel& sensor,
        const LaserModel& laser, const std::string& label, std::uint64_t seed)
      : caster_(world.ray_caster()),
        sensor_(sensor),
        laser_(laser),
        geometry_{laser.rays, laser.aperture(), laser.max_range},
        movers_(movers, geometry_),
        noise_(derive_seed(seed, stream(laser) + "/noise")),
        dropout_(derive_seed(seed, stream(laser) + "/dropout")),
        ranges_(static_cast<std::size_t>(laser.rays)),
        scan_(laser.name.empty() ? label : laser.name, laser.aperture(), laser.max_range) {
    scan_.sensorPose = {laser.x, laser.y, 0, laser.yaw, 0, laser.upside_down ? M_PI : 0};
  }

  const CObservation2DRangeScan& scan() const { return scan_; }

  void sense(const TPose2D& robot, double t, mrpt::Clock::time_point time) {
    const TPose2D pose = laser_.name.empty() ? robot : placed(robot);
    caster_.cast_scan(pose, geometry_, ranges_.data());
    movers_.add_to(pose, t, ranges_.data());
    if (laser_.upside_down) std::reverse(ranges_.begin(), ranges_.end());
    if (sensor_.noise_sigma > 0) add_noise();
    if (sensor_.dropout_ratio > 0) drop_rays();
    if (sensor_.quantum > 0) round_ranges();
    if (laser_.range_min > 0) drop_near();
    scan_.fill(ranges_, time);
  }

 private:
  static std::string stream(const LaserModel& laser) {
    return laser.name.empty() ? "sensor" : "laser." + laser.name;
  }

  TPose2D placed(const TPose2D& robot) const {
    const auto position = compose(robot, {laser_.x, laser_.y});
    return {position.x, position.y, robot.phi + laser_.yaw};
  }

  void add_noise() {
    for (float& range : ranges_) {
      const double error = normal(noise_, 0, sensor_.noise_sigma);
      if (range >= scan_.maxRange) continue;  // no return
      range = std::clamp(static_cast<float>(range + error), 0.0F, scan_.maxRange);
    }
  }

  void drop_rays() {
    for (float& range : ranges_)
      if (uniform_real(dropout_, 0, 1) < sensor_.dropout_ratio) range = scan_.maxRange;
  }

  void round_ranges() {
    for (float& range : ranges_) {
      if (range >= scan_.maxRange) continue;
      const double rounded = std::round(range / sensor_.quantum) * sensor_.quantum;
      range = std::min(static_cast<float>(rounded), scan_.maxRange);
    }
  }

  void drop_near() {
    for (float& range : ranges_)
      if (range < laser_.range_min) range = scan_.maxRange;
  }

  const RayCaster& caster_;
  const SensorModel& sensor_;
  LaserModel laser_;
  ScanGeometry geometry_;
  MoverScan movers_;
  RandomEngine noise_, dropout_;
  std::vector<float> ranges_;
  ReusedScan scan_;
};

RangeFinder::RangeFinder(const World& world, const Movers& movers, const SensorModel& sensor,
                         std::uint64_t seed)
    : sensor_(sensor) {
  constexpr const char* kLabel = "range_finder";
  for (const LaserModel& laser : sensor_.all_lasers()) {
    lasers_.push_back(std::make_unique<Laser>(world, movers, sensor_, laser, kLabel, seed));
    scans_.push_back(&lasers_.back()->scan());
  }
  if (!sensor_.lasers.empty() && !sensor_.lasers.front().raw)
    merged_ = std::make_unique<ReusedScan>(kLabel, sensor_.aperture(), sensor_.max_range);
}

RangeFinder::~RangeFinder() = default;

void RangeFinder::sense(const TPose2D& pose, double t, mrpt::Clock::time_point time,
                        Observation& observation) {
  for (const auto& laser : lasers_) laser->sense(pose, t, time);
  if (merged_) merged_->fill(merged_ranges(scans_, sensor_), time);
  observation.scan = merged_ ? merged_.get() : scans_.front();
  if (!sensor_.lasers.empty()) observation.lasers = scans_;
}

}  // namespace slalom
