#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// Exact any-angle search for the shortest path of a disc among the closed squares of an occupancy.
/// The lower bound is the exact any-angle optimum on cells that may contain a free configuration
/// (outer approximation of F_C), the upper bound is the one on cells all of whose points are free
/// (inner approximation), shortened by string pulling in the exact model. Cells are subdivided
/// until the gap is at most `target_gap` or `max_subdivision` is reached. If no such cells connect
/// start and goal, the upper bound is the safest path, shortened by string pulling. nullopt with
/// `reason` if start or goal is not free or no path exists (or none could be certified).
std::optional<ShortestPath> exact_shortest_path(const PlanningProblem& problem, double target_gap,
                                                std::string& reason, int max_subdivision = 4);

}  // namespace slalom
