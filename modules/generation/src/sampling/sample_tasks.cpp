// SPDX-License-Identifier: BSD-3-Clause
#include "solvable.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/references/exact_shortest.h>

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The connected components (8-neighborhood) of the cell centers with at least `radius` of
/// clearance: rejects most unconnected pairs without a path search. Positions are drawn among those
/// with at least `room`.
class FreeRegions {
 public:
  FreeRegions(const World& map, double radius, double room)
      : cells_(map.occupancy()), field_(map.distance_field()), region_(cells_.cells().size(), -1) {
    int regions = 0;
    for (std::size_t i = 0; i < region_.size(); ++i) {
      if (region_[i] >= 0 || !is_free(i, radius)) continue;
      flood(i, regions++, radius);
    }
    for (std::size_t i = 0; i < region_.size(); ++i)
      if (region_[i] >= 0 && is_free(i, room)) free_.push_back(i);
  }

  bool empty() const { return free_.empty(); }
  std::size_t draw(RandomEngine& engine) const {
    return free_[static_cast<std::size_t>(
        uniform_int(engine, 0, static_cast<int>(free_.size()) - 1))];
  }
  bool connected(std::size_t a, std::size_t b) const { return region_[a] == region_[b]; }
  TPoint2D center(std::size_t i) const { return cells_.cell_center(x_of(i), y_of(i)); }

 private:
  int x_of(std::size_t i) const {
    return static_cast<int>(i % static_cast<std::size_t>(cells_.size_x()));
  }
  int y_of(std::size_t i) const {
    return static_cast<int>(i / static_cast<std::size_t>(cells_.size_x()));
  }
  bool is_free(std::size_t i, double radius) const {
    return field_.at_center(x_of(i), y_of(i)) >= radius;
  }

  void flood(std::size_t from, int region, double radius) {
    std::vector<std::size_t> waiting = {from};
    region_[from] = region;
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (!cells_.inside(x_of(at) + dx, y_of(at) + dy)) continue;
          const std::size_t next = cells_.index(x_of(at) + dx, y_of(at) + dy);
          if (region_[next] >= 0 || !is_free(next, radius)) continue;
          region_[next] = region;
          waiting.push_back(next);
        }
    }
  }

  const Occupancy& cells_;
  const DistanceField& field_;
  std::vector<int> region_;
  std::vector<std::size_t> free_;
};

void expect_range(const char* what, double low, double high, double least) {
  if (low >= least && low <= high) return;
  throw usage_error(
      std::string("pairs with a ") + what + " from " + format_number(low) + " to " +
          format_number(high),
      "is an invalid interval",
      "a lower limit of at least " + format_number(least) + ", not above the upper limit");
}

/// Checks the constraints of a pair: from its positions alone, and from its shortest path.
class TaskFilter {
 public:
  TaskFilter(const World& map, const GenerationSettings& settings, const TaskConstraints& limits)
      : map_(map), settings_(settings), limits_(limits) {
    expect_range("distance", limits.min_distance, limits.max_distance, 0);
    expect_range("path length", limits.min_length, limits.max_length, 0);
    expect_range("detour ratio", limits.min_detour, limits.max_detour, 1);
  }

  /// Necessary condition: a path is at least as long as the straight line, and at most max_detour
  /// times that.
  bool may_fit(const TPoint2D& start, const TPoint2D& goal) const {
    const double straight = distance_between(goal, start);
    return straight >= limits_.min_distance && straight <= limits_.max_distance &&
           straight <= limits_.max_length && straight * limits_.max_detour >= limits_.min_length;
  }

  bool fits(const TPoint2D& start, const TPoint2D& goal, std::string& reason) const {
    const TaskConstraints any;
    const bool any_path =
        limits_.min_length <= any.min_length && limits_.max_length >= any.max_length &&
        limits_.min_detour <= any.min_detour && limits_.max_detour >= any.max_detour;
    if (any_path) return true;
    const auto path = exact_shortest_path(
        {map_, passing_radius(settings_.robot_radius, settings_.footprint), start, goal}, reason);
    if (!path) return false;
    const double detour = path->length / distance_between(goal, start);
    if (path->length < limits_.min_length || path->length > limits_.max_length) {
      reason = "the path's length is outside its limits";
    } else if (detour < limits_.min_detour || detour > limits_.max_detour) {
      reason = "the path's detour ratio is outside its limits";
    } else {
      return true;
    }
    return false;
  }

 private:
  const World& map_;
  const GenerationSettings& settings_;
  const TaskConstraints& limits_;
};

}  // namespace

std::vector<Scenario> sample_tasks(const Scenario& map, const GenerationSettings& settings,
                                   double min_distance) {
  TaskConstraints limits;
  limits.min_distance = min_distance;
  return sample_tasks(map, settings, limits);
}

std::vector<Scenario> sample_tasks(const Scenario& map, const GenerationSettings& settings,
                                   const TaskConstraints& limits) {
  constexpr double kMargin = 0.05;  // m, so that the robot does not start in contact
  constexpr int kDrawsPerAttempt = 1000;
  const Bounds& bounds = map.bounds();
  const double diagonal = math::hypot(bounds.width(), bounds.height());
  if (limits.min_distance > diagonal)
    throw usage_error(map.name(),
                      fmt::format("a distance of {:g} m between start and goal does not fit into "
                                  "the map, whose diagonal is {:.4g} m",
                                  limits.min_distance, diagonal),
                      "a smaller min_distance");
  const World world(map, settings.resolution);
  const FreeRegions regions(world,
                            passing_radius(settings.robot_radius, settings.footprint) + kMargin,
                            settings.robot_radius + kMargin);
  const TaskFilter filter(world, settings, limits);
  const SolvableSearch search(settings);
  std::set<std::string> hashes;
  std::vector<Scenario> scenarios;
  for (int i = 0; i < settings.count; ++i) {
    const std::string name = scenario_name(settings.name_prefix, i);
    const std::uint64_t seed = derive_seed(settings.seed, "pair", static_cast<std::uint64_t>(i));
    RandomEngine engine(seed);
    const auto draw = [&](int, std::string& reason) -> std::optional<Scenario> {
      for (int k = 0; k < kDrawsPerAttempt && !regions.empty(); ++k) {
        const std::size_t a = regions.draw(engine), b = regions.draw(engine);
        const TPoint2D start = regions.center(a), goal = regions.center(b);
        if (!regions.connected(a, b) || a == b || !filter.may_fit(start, goal)) continue;
        if (!filter.fits(start, goal, reason)) return std::nullopt;
        const double heading = uniform_real(engine, -M_PI, M_PI);
        return with_goal_heading(
            map.with_start_goal({start.x, start.y, heading}, goal).renamed(name), settings, seed);
      }
      reason = "no connected pair of free positions within the limits was drawn";
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
