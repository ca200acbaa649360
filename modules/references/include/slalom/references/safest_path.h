#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// The safest path P_V on the ridge (generalised Voronoi diagram) of the exact distance field: of
/// all paths the largest bottleneck clearance, then the shortest among those on the diagram; start
/// and goal are joined to it along steepest ascent of clearance. nullopt with `reason` when start
/// or goal is not free for the robot or no path wide enough exists.
std::optional<SafestPath> safest_path(const PlanningProblem& problem, std::string& reason);

}  // namespace slalom
