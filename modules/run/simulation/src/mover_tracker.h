// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/methods/method.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/mover.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace slalom {

/// Measures the tracks of movers, with the noise of the model. The random numbers of a cycle do not
/// depend on where the robot and the movers are.
class MoverTracker {
 public:
  /// Refers to the movers; those from index `scripted` on are people, as RunMovers has them. Each
  /// kind of noise uses its own random stream derived from `seed`.
  MoverTracker(const Movers& movers, const TrackerModel& model, std::uint64_t seed,
               std::size_t scripted = std::numeric_limits<std::size_t>::max());

  /// The tracks at time `t` (s) from the true pose of the robot at that time, by id: the index of
  /// the mover in its scenario. Overwritten by the next call.
  const std::vector<Track>& sense(const mrpt::math::TPose2D& pose, double t);

 private:
  mrpt::math::TPoint2D known_velocity(std::size_t i, double t) const;

  const Movers& movers_;
  std::size_t scripted_;
  TrackerModel model_;
  RandomEngine position_, velocity_, dropout_;
  std::vector<Track> tracks_;
};

}  // namespace slalom
