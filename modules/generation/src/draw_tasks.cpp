#include "solvable.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/references/exact_shortest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The free places of a map for a disc, in connected areas (8 neighbours of cell centres that keep
/// the radius): tells at once most pairs that no path joins.
class FreeAreas {
 public:
  FreeAreas(const World& map, double radius)
      : cells_(map.occupancy()), field_(map.distance_field()), area_(cells_.cells().size(), -1) {
    int areas = 0;
    for (std::size_t i = 0; i < area_.size(); ++i) {
      if (area_[i] >= 0 || !is_open(i, radius)) continue;
      flood(i, areas++, radius);
    }
    for (std::size_t i = 0; i < area_.size(); ++i)
      if (area_[i] >= 0) open_.push_back(i);
  }

  bool empty() const { return open_.empty(); }
  std::size_t draw(RandomEngine& engine) const {
    return open_[static_cast<std::size_t>(
        uniform_int(engine, 0, static_cast<int>(open_.size()) - 1))];
  }
  bool joined(std::size_t a, std::size_t b) const { return area_[a] == area_[b]; }
  TPoint2D center(std::size_t i) const { return cells_.cell_center(x_of(i), y_of(i)); }

 private:
  int x_of(std::size_t i) const {
    return static_cast<int>(i % static_cast<std::size_t>(cells_.size_x()));
  }
  int y_of(std::size_t i) const {
    return static_cast<int>(i / static_cast<std::size_t>(cells_.size_x()));
  }
  bool is_open(std::size_t i, double radius) const {
    return field_.at_center(x_of(i), y_of(i)) >= radius;
  }

  void flood(std::size_t from, int area, double radius) {
    std::vector<std::size_t> waiting = {from};
    area_[from] = area;
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (!cells_.inside(x_of(at) + dx, y_of(at) + dy)) continue;
          const std::size_t next = cells_.index(x_of(at) + dx, y_of(at) + dy);
          if (area_[next] >= 0 || !is_open(next, radius)) continue;
          area_[next] = area;
          waiting.push_back(next);
        }
    }
  }

  const Occupancy& cells_;
  const DistanceField& field_;
  std::vector<int> area_;
  std::vector<std::size_t> open_;
};

void expect_range(const char* what, double low, double high, double least) {
  if (low >= least && low <= high) return;
  throw usage_error(
      std::string("pairs with a ") + what + " from " + format_number(low) + " to " +
          format_number(high),
      "cannot be", "a first number of at least " + format_number(least) + ", not above the second");
}

/// What of a pair can be told from its places, and what only from the shortest path.
class TaskFilter {
 public:
  TaskFilter(const World& map, const GenerationTask& task, const TaskLimits& limits)
      : map_(map), task_(task), limits_(limits) {
    expect_range("distance", limits.min_distance, limits.max_distance, 0);
    expect_range("path length", limits.min_length, limits.max_length, 0);
    expect_range("detour ratio", limits.min_detour, limits.max_detour, 1);
  }

  /// A path is no shorter than the straight line, and no longer than the largest detour.
  bool may_fit(const TPoint2D& start, const TPoint2D& goal) const {
    const double straight = std::hypot(goal.x - start.x, goal.y - start.y);
    return straight >= limits_.min_distance && straight <= limits_.max_distance &&
           straight <= limits_.max_length && straight * limits_.max_detour >= limits_.min_length;
  }

  bool fits(const TPoint2D& start, const TPoint2D& goal, std::string& reason) const {
    const TaskLimits any;
    const bool any_path =
        limits_.min_length <= any.min_length && limits_.max_length >= any.max_length &&
        limits_.min_detour <= any.min_detour && limits_.max_detour >= any.max_detour;
    if (any_path) return true;
    constexpr double kGap = 0.01;
    const auto path = exact_shortest_path({map_, task_.robot_radius, start, goal}, kGap, reason);
    if (!path) return false;
    const double detour = path->length / std::hypot(goal.x - start.x, goal.y - start.y);
    if (path->length < limits_.min_length || path->length > limits_.max_length) {
      reason = "the path's length is not the wanted one";
    } else if (detour < limits_.min_detour || detour > limits_.max_detour) {
      reason = "the path's detour ratio is not the wanted one";
    } else {
      return true;
    }
    return false;
  }

 private:
  const World& map_;
  const GenerationTask& task_;
  const TaskLimits& limits_;
};

}  // namespace

std::vector<Scenario> draw_tasks(const Scenario& map, const GenerationTask& task,
                                 double min_distance) {
  TaskLimits limits;
  limits.min_distance = min_distance;
  return draw_tasks(map, task, limits);
}

std::vector<Scenario> draw_tasks(const Scenario& map, const GenerationTask& task,
                                 const TaskLimits& limits) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr double kMargin = 0.05;  // m, so that the robot does not begin by touching
  constexpr int kDrawsPerAttempt = 1000;
  const World world(map, task.resolution);
  const FreeAreas areas(world, task.robot_radius + kMargin);
  const TaskFilter filter(world, task, limits);
  const SolvableSearch search(task);
  std::set<std::string> hashes;
  std::vector<Scenario> scenarios;
  for (int i = 0; i < task.count; ++i) {
    const std::string name = scenario_name(task.name_prefix, i);
    RandomEngine engine(derive_seed(task.seed, "pair", static_cast<std::uint64_t>(i)));
    const auto draw = [&](int, std::string& reason) -> std::optional<Scenario> {
      for (int k = 0; k < kDrawsPerAttempt && !areas.empty(); ++k) {
        const std::size_t a = areas.draw(engine), b = areas.draw(engine);
        const TPoint2D start = areas.center(a), goal = areas.center(b);
        if (!areas.joined(a, b) || a == b || !filter.may_fit(start, goal)) continue;
        if (!filter.fits(start, goal, reason)) return std::nullopt;
        const double heading = uniform_real(engine, -kPi, kPi);
        return map.with_task({start.x, start.y, heading}, goal).renamed(name);
      }
      reason = "no two joined free places that far apart were drawn";
      return std::nullopt;
    };
    SolvableWorld found = search.find(name, draw);
    while (!hashes.insert(found.world->scenario().hash()).second)
      found = search.find(name, draw, found.attempt + 1);
    scenarios.push_back(found.world->scenario());
  }
  return scenarios;
}

}  // namespace slalom
