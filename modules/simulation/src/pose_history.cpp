#include "pose_history.h"

namespace slalom {
namespace {

/// Times are sums of steps; this much (s) absorbs their rounding.
constexpr double kTimeTolerance = 1e-9;

}  // namespace

void PoseHistory::add(double time, const mrpt::math::TPose2D& pose) {
  if (memory_ <= 0) {
    entries_.assign(1, {time, pose});
    return;
  }
  entries_.push_back({time, pose});
  // The second entry serves everything that is asked for: the first is no longer needed.
  while (entries_.size() > 1 && entries_[1].time <= time - memory_ + kTimeTolerance)
    entries_.erase(entries_.begin());
}

const mrpt::math::TPose2D& PoseHistory::at(double time) const {
  std::size_t i = entries_.size() - 1;
  while (i > 0 && entries_[i].time > time + kTimeTolerance) --i;
  return entries_[i].pose;
}

}  // namespace slalom
