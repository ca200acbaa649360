// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/svg_scene.h>
#include <slalom/rawlog/run_reader.h>
#include <slalom/robot/robot_model.h>

namespace slalom {

/// The end points of the rays of a cycle's scan in the world frame. The cycle has a sample.
Path scan_ends(const RecordedRun& run, std::size_t cycle);

/// The picture of a run at one sample of its trajectory: robot, scan (there is none after the last
/// cycle), traveled path, and the time at which movers are drawn.
SceneOptions scene_at(const RecordedRun& run, std::size_t sample, const RobotModel& robot,
                      int max_pixels);

}  // namespace slalom
