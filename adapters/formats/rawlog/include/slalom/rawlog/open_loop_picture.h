// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/log_map.h>
#include <slalom/rawlog/open_loop.h>

#include <string>
#include <vector>

namespace slalom {

/// The drive of a log and what a method would have done, as one SVG element: the surroundings, the
/// driven path (gray), and from its poses the commands of the method, each held for one second:
/// green without a predicted contact, orange with one, red with a cross where the robot could not
/// have stopped or was in contact already. One command per 0.25 m, and all red ones. `map` is that
/// of the same log, in the frame of its odometry.
std::string open_loop_picture(const LogMap& map, const std::vector<LoggedScan>& scans,
                              const std::vector<OpenLoopAnswer>& answers, double robot_radius);

}  // namespace slalom
