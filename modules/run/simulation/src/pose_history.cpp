// SPDX-License-Identifier: BSD-3-Clause
#include "pose_history.h"

namespace slalom {
namespace {

/// Tolerance (s) for rounding errors of times, which are sums of steps.
constexpr double kEntryTolerance = 1e-9;

}  // namespace

void PoseHistory::add(double time, const mrpt::math::TPose2D& pose) {
  if (memory_ <= 0) {
    entries_.assign(1, {time, pose});
    return;
  }
  entries_.push_back({time, pose});
  // The second entry covers all possible queries: the first is no longer needed.
  while (entries_.size() > 1 && entries_[1].time <= time - memory_ + kEntryTolerance)
    entries_.erase(entries_.begin());
}

const mrpt::math::TPose2D& PoseHistory::at(double time) const {
  std::size_t i = entries_.size() - 1;
  while (i > 0 && entries_[i].time > time + kEntryTolerance) --i;
  return entries_[i].pose;
}

}  // namespace slalom
