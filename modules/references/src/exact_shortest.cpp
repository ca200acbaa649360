#include "configuration_cells.h"
#include "string_pulling.h"

#include <slalom/core/distance.h>
#include <slalom/references/any_angle.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/references/safest_path.h>

#include <algorithm>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Maximum number of subcells (about 40 bytes each while searching).
constexpr std::size_t kMaxSubcells = 24'000'000;

class ExactSearch {
 public:
  explicit ExactSearch(const PlanningProblem& problem)
      : problem_(problem), cells_(problem.world.occupancy()) {}

  bool is_free_at(const TPoint2D& p) const {
    return is_free(problem_.world, {p}, problem_.robot_radius);
  }

  bool can_subdivide(int subdivision) const {
    const auto k = static_cast<std::size_t>(subdivision);
    return cells_.cells().size() * k * k <= kMaxSubcells;
  }

  /// Updates the bounds with one subdivision. Returns false if the outer cells prove that no path
  /// exists.
  bool refine(int subdivision, double& lower, std::optional<Path>& best) const {
    const ConfigurationCells grid =
        make_configuration_cells(cells_, problem_.robot_radius, subdivision);
    const auto outer = shortest_any_angle_path(grid.outer, to_cells(problem_.start, grid),
                                               to_cells(problem_.goal, grid));
    if (!outer) return false;
    lower = std::max(lower, length(*outer) * grid.cell_size);
    if (auto path = free_path(grid); path && (!best || length(*path) < length(*best)))
      best = std::move(path);
    return true;
  }

 private:
  TPoint2D to_cells(const TPoint2D& p, const ConfigurationCells& grid) const {
    const double x = (p.x - cells_.origin().x) / grid.cell_size;
    const double y = (p.y - cells_.origin().y) / grid.cell_size;
    return {std::clamp(x, 0.0, static_cast<double>(grid.inner.size_x)),
            std::clamp(y, 0.0, static_cast<double>(grid.inner.size_y))};
  }

  TPoint2D to_world(const TPoint2D& p, const ConfigurationCells& grid) const {
    return {cells_.origin().x + p.x * grid.cell_size, cells_.origin().y + p.y * grid.cell_size};
  }

  std::optional<Path> free_path(const ConfigurationCells& grid) const {
    const auto start = entrance(problem_.start, grid), goal = entrance(problem_.goal, grid);
    if (!start || !goal) return std::nullopt;
    const auto inner = shortest_any_angle_path(grid.inner, *start, *goal);
    if (!inner) return std::nullopt;
    Path path = {problem_.start};
    for (const TPoint2D& p : *inner) path.push_back(to_world(p, grid));
    path.push_back(problem_.goal);
    path = pull_string(problem_.world, without_duplicates(path), problem_.robot_radius);
    if (!is_free(problem_.world, path, problem_.robot_radius)) return std::nullopt;
    return path;
  }

  static Path without_duplicates(const Path& path) {
    Path result;
    for (const TPoint2D& p : path)
      if (result.empty() || distance_between(p, result.back()) > 1e-9) result.push_back(p);
    if (result.size() == 1) result.push_back(path.back());
    return result;
  }

  /// The point (cells) at which the robot enters the inner cells from p: p itself, or the center of
  /// the nearest inner cell reachable on a free straight line.
  std::optional<TPoint2D> entrance(const TPoint2D& p, const ConfigurationCells& grid) const {
    const TPoint2D at = to_cells(p, grid);
    const int cx = static_cast<int>(at.x), cy = static_cast<int>(at.y);
    if (!grid.inner.is_blocked(cx, cy)) return at;
    constexpr int kReach = 6;  // cells
    std::optional<TPoint2D> best;
    double best_distance = 0;
    for (int y = cy - kReach; y <= cy + kReach; ++y)
      for (int x = cx - kReach; x <= cx + kReach; ++x) {
        if (grid.inner.is_blocked(x, y)) continue;
        const TPoint2D center(x + 0.5, y + 0.5);
        const double distance = distance_between(center, at);
        if (best && distance >= best_distance) continue;
        if (!is_free(problem_.world, {p, to_world(center, grid)}, problem_.robot_radius)) continue;
        best = center;
        best_distance = distance;
      }
    return best;
  }

  const PlanningProblem& problem_;
  const Occupancy& cells_;
};

/// For passages too narrow for completely free cells: the medial path, shortened by string pulling.
std::optional<Path> medial_path(const PlanningProblem& problem) {
  std::string ignored;
  const std::optional<SafestPath> safest = safest_path(problem, ignored);
  if (!safest || !is_free(problem.world, safest->path, problem.robot_radius)) return std::nullopt;
  return pull_string(problem.world, safest->path, problem.robot_radius);
}

/// A path with the proven bounds; a straight path is optimal independent of the cells.
ShortestPath certified(Path path, double lower, const PlanningProblem& problem) {
  const double found = length(path);
  const double straight = distance_between(problem.goal, problem.start);
  ShortestPath result;
  result.length = found;
  result.certificate = {std::min(std::max(lower, straight), found), found};
  result.path = std::move(path);
  result.planner = kExactPlanner;
  return result;
}

}  // namespace

std::optional<ShortestPath> exact_shortest_path(const PlanningProblem& problem, double target_gap,
                                                std::string& reason, int max_subdivision) {
  const ExactSearch search(problem);
  for (const auto& [p, name] : {std::pair(problem.start, "start"), std::pair(problem.goal, "goal")})
    if (!search.is_free_at(p)) {
      reason = std::string(name) + " is closer to an obstacle than the robot's radius";
      return std::nullopt;
    }
  double lower = 0;
  std::optional<Path> best;
  for (int k = 1; k <= max_subdivision && (k == 1 || search.can_subdivide(k)); k *= 2) {
    if (!search.refine(k, lower, best)) {
      reason = "no path from start to goal is wide enough for the robot";
      return std::nullopt;
    }
    if (best && length(*best) <= (1 + target_gap) * lower) break;
  }
  if (!best) best = medial_path(problem);
  if (!best) {
    reason = "no path could be certified: the passage is too narrow for this resolution";
    return std::nullopt;
  }
  return certified(std::move(*best), lower, problem);
}

}  // namespace slalom
