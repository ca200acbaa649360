// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/run_recorder.h>

#include <memory>
#include <string>

namespace slalom {

/// Observes one run and writes it at its end as a bag of ROS 2 (MCAP) to `path` (atomically), with
/// the topics and frames of a robot: /scan, or /scan_NAME of each of several lasers, /odom, /tf,
/// /tf_static, /cmd_vel, /goal_pose, /map, /ground_truth and, if something moves, /movers. The
/// scenario and `setup` are those of the run. The bytes depend only on the run. on_end() throws
/// Error (Job) if the file cannot be written.
std::unique_ptr<RunObserver> make_bag_recorder(const std::string& path, const RunManifest& manifest,
                                               const Scenario& scenario, const RunSetup& setup);

}  // namespace slalom
