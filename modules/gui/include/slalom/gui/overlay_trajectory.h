#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/trajectory/trajectory.h>

#include <cstddef>
#include <memory>
#include <nanogui/nanogui.h>
#include <optional>
#include <string>

namespace slalom {

/// One run to be drawn over its scenario, at one instant of its replay.
struct OverlayTrajectory {
  std::string label;    ///< e.g. "nd 0": method and repetition
  std::string outcome;  ///< e.g. "success"; its end is marked in outcome_color()
  nanogui::Color color;
  std::shared_ptr<const Trajectory> trajectory;  ///< all of the run; not null, not empty
  double time = 0;                               ///< of the replay, s after the first sample
  std::size_t sample = 0;                        ///< the last one that is not later than `time`
  mrpt::math::TPose2D pose;            ///< at `time`, between samples; where it ended, later
  std::optional<Footprint> footprint;  ///< of the robot, if it is known
  std::shared_ptr<const Path> scan;    ///< where rays from `pose` end, or null
};

}  // namespace slalom
