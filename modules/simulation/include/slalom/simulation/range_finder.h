// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/simulation/mover_scan.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace slalom {

/// The robot's range sensor in a world: fills one scan that is reused in every cycle. Rays go
/// counter-clockwise from -aperture/2; a ray without return has range max_range and is invalid.
/// Noise and dropouts draw a number for every ray, with or without return, each from its own
/// stream: one option does not change the numbers of another.
class RangeFinder {
 public:
  RangeFinder(const World& world, const SensorModel& sensor, std::uint64_t seed);

  /// The scan at `pose`, stamped `time`, with the movers as they are at `t` (s of the run).
  const mrpt::obs::CObservation2DRangeScan& sense(const mrpt::math::TPose2D& pose, double t,
                                                  mrpt::Clock::time_point time);

 private:
  /// MRPT caches the points of a scan (buildAuxPointsMap) even if the ranges change; a reused scan
  /// must clear them, or methods would get outdated points.
  class ReusedScan : public mrpt::obs::CObservation2DRangeScan {
   public:
    void clear_points() { m_cachedMap.reset(); }
  };

  void add_noise();
  void drop_rays();
  void round_ranges();

  const RayCaster& caster_;
  SensorModel sensor_;
  ScanGeometry geometry_;
  MoverScan movers_;
  RandomEngine noise_, dropout_;
  std::vector<float> ranges_;
  std::vector<char> valid_;
  ReusedScan scan_;
};

}  // namespace slalom
