// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/trajectory_file.h>

#include <string>

namespace slalom {

/// Reads the poses of a robot from a bag, as load_trajectory_file() reads those of a file: from a
/// topic with Odometry, PoseStamped or PoseWithCovarianceStamped, "" for the only one, or from the
/// transforms between two frames: "/tf:map.base_link". Velocities are the twists of odometry,
/// unless all are zero, or differences of poses; times are those of the headers.
///
/// Throws Error (File) as read_bag() and load_trajectory_file(), and if there is no such topic or
/// frame, or several fit.
TrajectoryFile load_bag_trajectory(const std::string& path, const std::string& topic, bool sideways,
                                   const LogSelection& selection = {});

}  // namespace slalom
