// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// The safest path P_V on the generalized Voronoi diagram, the ridge of the exact distance field:
/// it has the maximum bottleneck clearance of all paths over 8-connected cell centers
/// (widest_bottleneck()), and is the shortest of those on the diagram; start and goal are connected
/// to it along the steepest ascent of clearance. The diagram made of cells has gaps: path segments
/// of that bottleneck off the diagram are allowed at ten times their length. nullopt with `reason`
/// if start or goal is not free for the robot or no such path is wide enough for it.
std::optional<SafestPath> safest_path(const PlanningProblem& problem, std::string& reason);

}  // namespace slalom
