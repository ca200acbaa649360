#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// The safest path P_V on the generalised Voronoi diagram, the ridge of the exact distance field:
/// of all paths over 8-connected cell centres the largest bottleneck clearance (that of
/// widest_bottleneck()), then the shortest among those on the diagram; start and goal are joined to
/// it along steepest ascent of clearance. A diagram made of cells has gaps: off it a way of that
/// bottleneck may go on, at ten times its length. nullopt with `reason` when start or goal is not
/// free for the robot or no such path is wide enough for it.
std::optional<SafestPath> safest_path(const PlanningProblem& problem, std::string& reason);

}  // namespace slalom
