#pragma once

#include <slalom/core/random.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace slalom {

/// The robot's range sensor in a world: fills one scan that is reused from cycle to cycle.
/// Rays go counter-clockwise from -aperture/2; a ray that meets nothing has range max_range and is
/// not valid. Noise and dropouts draw for every ray, met or not, each from a stream of its own: one
/// option does not change the numbers of another.
class RangeFinder {
 public:
  RangeFinder(const World& world, const SensorModel& sensor, std::uint64_t seed);

  const mrpt::obs::CObservation2DRangeScan& sense(const mrpt::math::TPose2D& pose,
                                                  mrpt::Clock::time_point time);

 private:
  /// MRPT keeps the points of a scan (buildAuxPointsMap) when the ranges change; a scan that is
  /// used again must forget them, or a method sees obstacles where they were when it first asked.
  class ReusedScan : public mrpt::obs::CObservation2DRangeScan {
   public:
    void forget_points() { m_cachedMap.reset(); }
  };

  void add_noise();
  void drop_rays();
  void round_ranges();

  const RayCaster& caster_;
  SensorModel sensor_;
  ScanGeometry geometry_;
  RandomEngine noise_, dropout_;
  std::vector<float> ranges_;
  std::vector<char> valid_;
  ReusedScan scan_;
};

}  // namespace slalom
