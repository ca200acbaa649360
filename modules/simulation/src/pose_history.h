#pragma once

#include <mrpt/math/TPose2D.h>

#include <vector>

namespace slalom {

/// Where the robot was some time ago, for a sensor whose scans arrive late.
class PoseHistory {
 public:
  /// Poses older than `memory` (s) are forgotten; with 0 only the last one is kept.
  explicit PoseHistory(double memory) : memory_(memory) {}

  void add(double time, const mrpt::math::TPose2D& pose);
  /// The last pose at `time` or before it; the first one where there is none.
  const mrpt::math::TPose2D& at(double time) const;

 private:
  struct Entry {
    double time;
    mrpt::math::TPose2D pose;
  };
  double memory_;
  std::vector<Entry> entries_;
};

}  // namespace slalom
