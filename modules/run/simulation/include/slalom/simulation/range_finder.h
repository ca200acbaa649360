// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/scenario/world.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <memory>
#include <vector>

namespace slalom {

/// The robot's range sensor in a world: fills scans that are reused in every cycle. Rays go
/// counter-clockwise from -aperture/2; a ray without return has range max_range and is invalid.
/// Noise and dropouts draw a number for every ray, with or without return, each from its own
/// stream: one option does not change the numbers of another.
class RangeFinder {
 public:
  /// Among the static obstacles of `world` and `movers`; both must outlive this.
  RangeFinder(const World& world, const Movers& movers, const SensorModel& sensor,
              std::uint64_t seed);
  ~RangeFinder();
  RangeFinder(const RangeFinder&) = delete;
  RangeFinder& operator=(const RangeFinder&) = delete;

  /// Fills the scans at `pose` of the robot, stamped `time`, with the movers as they are at `t` (s
  /// of the run), in an observation.
  void sense(const mrpt::math::TPose2D& pose, double t, mrpt::Clock::time_point time,
             Observation& observation);

 private:
  class Laser;
  class ReusedScan;

  SensorModel sensor_;
  std::vector<std::unique_ptr<Laser>> lasers_;  ///< one at the center if the robot has none
  std::vector<const mrpt::obs::CObservation2DRangeScan*> scans_;  ///< of lasers_
  std::unique_ptr<ReusedScan> merged_;  ///< null if methods get the scan of the first laser
};

}  // namespace slalom
