// SPDX-License-Identifier: BSD-3-Clause
#include "diagram.h"

#include <slalom/references/safest_path.h>
#include <slalom/scenario/widest_path.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

GridCell cell_of(const Occupancy& cells, const TPoint2D& p) {
  const TPoint2D at = cells.to_cells(p);
  return {std::clamp(static_cast<int>(at.x), 0, cells.size_x() - 1),
          std::clamp(static_cast<int>(at.y), 0, cells.size_y() - 1)};
}

/// Ascents from start and goal may share cells: removes loops.
std::vector<GridCell> without_loops(const std::vector<GridCell>& path, const Occupancy& cells) {
  constexpr int kNotVisited = -1;
  std::vector<int> visited_at(cells.cells().size(), kNotVisited);
  std::vector<GridCell> result;
  for (const GridCell& c : path) {
    const int seen = visited_at[cells.index(c.x, c.y)];
    if (seen == kNotVisited) {
      visited_at[cells.index(c.x, c.y)] = static_cast<int>(result.size());
      result.push_back(c);
      continue;
    }
    while (static_cast<int>(result.size()) > seen + 1) {
      visited_at[cells.index(result.back().x, result.back().y)] = kNotVisited;
      result.pop_back();
    }
  }
  return result;
}

/// Cells from start to goal: up to the diagram, along it, and down again.
std::vector<GridCell> safest_cells(const PlanningProblem& problem, double bottleneck) {
  const Occupancy& cells = problem.world.occupancy();
  const GridCell ends[2] = {cell_of(cells, problem.start), cell_of(cells, problem.goal)};
  const Diagram diagram(problem.world, bottleneck, ends);
  std::vector<GridCell> path = diagram.ascend(ends[0]);
  const std::vector<GridCell> down = diagram.ascend(ends[1]);
  const std::vector<GridCell> along = diagram.shortest(path.back(), down.back());
  path.insert(path.end(), along.begin(), along.end());
  path.insert(path.end(), down.rbegin(), down.rend());
  return without_loops(path, cells);
}

Path path_through(const std::vector<GridCell>& cells, const PlanningProblem& problem) {
  Path path = {problem.start};
  for (std::size_t i = 1; i + 1 < cells.size(); ++i)
    path.push_back(problem.world.occupancy().cell_center(cells[i].x, cells[i].y));
  path.push_back(problem.goal);
  return path;
}

}  // namespace

std::optional<SafestPath> safest_path(const PlanningProblem& problem, std::string& reason) {
  for (const auto& [p, name] : {std::pair(problem.start, "start"), std::pair(problem.goal, "goal")})
    if (!is_free(problem.world, {p}, problem.robot_radius)) {
      reason = std::string(name) + " is closer to an obstacle than the robot's radius";
      return std::nullopt;
    }
  SafestPath result;
  result.bottleneck = widest_bottleneck(problem.world, problem.start, problem.goal);
  if (result.bottleneck > 0 && result.bottleneck >= problem.robot_radius) {
    result.path = path_through(safest_cells(problem, result.bottleneck), problem);
    if (is_free(problem.world, result.path, problem.robot_radius)) return result;
  }
  reason = "no path over cell centers is wide enough for the robot";
  return std::nullopt;
}

}  // namespace slalom
