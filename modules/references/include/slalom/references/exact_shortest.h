#pragma once

#include <slalom/references/reference.h>

#include <optional>
#include <string>

namespace slalom {

/// Exact any-angle search for the shortest path of a disc among the closed squares of an occupancy.
/// The lower bound is the exact any-angle optimum on cells of which some point may be free for the
/// robot (outer approximation of F_C), the upper bound comes from cells all of whose points are
/// free (inner approximation), pulled taut in the exact model. Cells are split until the gap is at
/// most `wanted_gap` or `max_subdivision` is reached. Where no such cells join start and goal, the
/// upper bound is the safest path, pulled taut. nullopt with `reason` when start or goal is not
/// free or no path exists (or none could be certified).
std::optional<ShortestPath> exact_shortest_path(const PlanningProblem& problem, double wanted_gap,
                                                std::string& reason, int max_subdivision = 4);

}  // namespace slalom
