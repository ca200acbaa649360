// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/references/disc_path.h>
#include <slalom/references/exact_shortest.h>

namespace slalom {

std::optional<ShortestPath> exact_shortest_path(const PlanningProblem& problem,
                                                std::string& reason) {
  const Occupancy& cells = problem.world.occupancy();
  const std::optional<DiscPath> found =
      shortest_disc_path(cells, problem.robot_radius, problem.start, problem.goal, reason);
  if (!found) return std::nullopt;
  ShortestPath result;
  result.path = to_polyline(*found, cells);
  result.length = result.exact_length = found->length;
  result.certificate = {found->length, found->length};
  result.planner = kExactPlanner;
  return result;
}

}  // namespace slalom
