// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose2D.h>

#include <vector>

namespace slalom {

/// The past poses of the robot, for a sensor with latency.
class PoseHistory {
 public:
  /// Poses older than `memory` (s) are discarded; with 0 only the last one is kept.
  explicit PoseHistory(double memory) : memory_(memory) {}

  void add(double time, const mrpt::math::TPose2D& pose);
  /// The last pose at or before `time`; the first one if there is none.
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
