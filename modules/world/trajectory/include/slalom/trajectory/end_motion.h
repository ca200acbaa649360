// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/trajectory/trajectory.h>

#include <array>

namespace slalom {

/// Motion of the robot in the last kEndWindow of a failed run.
enum class EndMotion {
  Fast,     ///< ended above half of the maximum speed
  Slow,     ///< ended below it; of collisions and failures of the method
  Stopped,  ///< of the other failures: drove less than one radius, turned less than 90 degrees
  Turning,  ///< drove less than one radius, turned more
  Driving   ///< drove more than one radius
};
constexpr auto enum_names(EndMotion) {
  return std::array{"above half of the maximum speed", "below half of the maximum speed", "stops",
                    "turns in place", "keeps driving"};
}

constexpr double kEndWindow = 5;  ///< s

/// `radius` (m) and `max_v` (m/s) are the robot's. Requires at least one sample.
EndMotion end_motion(Outcome outcome, const Trajectory& trajectory, double radius, double max_v);

}  // namespace slalom
