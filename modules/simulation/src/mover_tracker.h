// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/methods/method.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/mover.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// Measures the tracks of movers, with the noise of the model. The random numbers of a cycle do not
/// depend on where the robot and the movers are.
class MoverTracker {
 public:
  /// Refers to the movers. Each kind of noise uses its own random stream derived from `seed`.
  MoverTracker(const Movers& movers, const TrackerModel& model, std::uint64_t seed);

  /// The tracks at time `t` (s) from the true pose of the robot at that time, by id: the index of
  /// the mover in its scenario. Overwritten by the next call.
  const std::vector<Track>& sense(const mrpt::math::TPose2D& pose, double t);

 private:
  const Movers& movers_;
  TrackerModel model_;
  RandomEngine position_, velocity_, dropout_;
  std::vector<Track> tracks_;
};

}  // namespace slalom
