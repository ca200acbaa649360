// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/rolling_memory.h"
#include "dwa_local_planner/footprint.h"
#include "dwa_local_planner/parameters.h"

#include <optional>
#include <vector>

namespace dwa_local_planner {

/// The recovery behaviors of move_base, one after another whenever the robot gets stuck: clear the
/// costmap far from the robot, rotate once in place, back up (if allowed), clear it close to the
/// robot, rotate again. After the last one they begin again.
class Recovery {
 public:
  Recovery(const Parameters& parameters, const reactive::Robot& robot, const Footprint& footprint);

  void reset() { next_ = 0, is_active_ = false; }
  /// Goes on with its behavior, if the list of behaviors is the same.
  void take_over(const Recovery& before);
  /// The robot moves again: the first behavior is the next.
  void succeeded() { next_ = 0; }
  /// Begins the next behavior. Nothing happens if there are none.
  void start(const reactive::Pose& pose, reactive::RollingMemory& memory);
  /// The command of the behavior; nothing when none is active, it has ended or an obstacle is in
  /// its way.
  std::optional<reactive::Twist> step(const reactive::Costmap& map, const reactive::Pose& pose);

 private:
  enum class Behavior { ConservativeReset, Rotate, BackUp, AggressiveReset };

  std::optional<reactive::Twist> rotate(const reactive::Costmap& map, const reactive::Pose& pose);
  std::optional<reactive::Twist> back_up(const reactive::Costmap& map, const reactive::Pose& pose);

  Parameters parameters_;
  Footprint footprint_;
  std::vector<Behavior> behaviors_;
  std::size_t next_ = 0;  ///< the behavior after the one that is active
  bool is_active_ = false;
  reactive::Pose begin_, last_;
  double turned_ = 0;  ///< rad
};

}  // namespace dwa_local_planner
