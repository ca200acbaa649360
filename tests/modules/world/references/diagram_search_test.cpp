// SPDX-License-Identifier: BSD-3-Clause
#include "diagram.h"
#include "reference_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace slalom {
namespace {

/// From a wide cell to a wide one, and not around an occupied corner, whatever the clearance.
bool may_step(const Diagram& diagram, const Occupancy& cells, const GridCell& from,
              const Step& step) {
  return diagram.may_step(from, step) && !cells.occupied(from.x + step.dx, from.y) &&
         !cells.occupied(from.x, from.y + step.dy);
}

/// Costs of the shortest paths on a diagram from a cell to all others, by Dijkstra's algorithm over
/// all steps. Lengths are at most about 1,000 steps, so that different sums of 1 and sqrt(2) differ
/// by more than 1e-4: equal costs are those within kEqual.
class PlainCosts {
 public:
  static constexpr double kEqual = 1e-5;

  PlainCosts(const Diagram& diagram, const Occupancy& cells, const GridCell& from)
      : diagram_(diagram), cells_(cells), cost_(cells.cells().size(), kUnreached) {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    at(from) = 0;
    queue.emplace(0, cells.index(from.x, from.y));
    const auto size_x = static_cast<std::size_t>(cells.size_x());
    while (!queue.empty()) {
      const auto [cost, index] = queue.top();
      queue.pop();
      if (cost > cost_[index]) continue;
      const GridCell cell{static_cast<int>(index % size_x), static_cast<int>(index / size_x)};
      for (const Step& step : kSteps) {
        if (!may_step(diagram, cells, cell, step)) continue;
        const GridCell next{cell.x + step.dx, cell.y + step.dy};
        if (cost + step_cost(step, next) >= at(next)) continue;
        at(next) = cost + step_cost(step, next);
        queue.emplace(at(next), cells.index(next.x, next.y));
      }
    }
  }

  double step_cost(const Step& step, const GridCell& to) const {
    return (diagram_.contains(to) ? 1 : 10) * step.length;
  }
  bool reached(const GridCell& c) const { return cost_[cells_.index(c.x, c.y)] < kUnreached; }
  double operator()(const GridCell& c) const { return cost_[cells_.index(c.x, c.y)]; }

 private:
  static constexpr double kUnreached = std::numeric_limits<double>::infinity();
  double& at(const GridCell& c) { return cost_[cells_.index(c.x, c.y)]; }
  const Diagram& diagram_;
  const Occupancy& cells_;
  std::vector<double> cost_;
};

/// The first cell with the largest d from which a shortest path may enter `to`.
GridCell best_predecessor(const Diagram& diagram, const World& world, const PlainCosts& costs,
                          const GridCell& to) {
  GridCell best = to;
  double clearance = -1;
  for (const Step& step : kSteps) {
    const GridCell from{to.x - step.dx, to.y - step.dy};
    if (!world.occupancy().inside(from.x, from.y) || !costs.reached(from)) continue;
    if (!may_step(diagram, world.occupancy(), from, step)) continue;
    if (costs(from) + costs.step_cost(step, to) > costs(to) + PlainCosts::kEqual) continue;
    if (world.distance_field().at_center(from.x, from.y) <= clearance) continue;
    clearance = world.distance_field().at_center(from.x, from.y);
    best = from;
  }
  return best;
}

GridCell random_cell(RandomEngine& random, const Occupancy& cells) {
  return {uniform_int(random, 0, cells.size_x() - 1), uniform_int(random, 0, cells.size_y() - 1)};
}

/// Compares the paths between random pairs of cells; returns the number of paths with steps off the
/// diagram between cells on it.
int compare_paths(RandomEngine& random, const World& world, double bottleneck) {
  const Occupancy& cells = world.occupancy();
  int bridged = 0;
  for (int pair = 0; pair < 6; ++pair) {
    const GridCell ends[2] = {random_cell(random, cells), random_cell(random, cells)};
    const auto d = [&](const GridCell& c) { return world.distance_field().at_center(c.x, c.y); };
    if (d(ends[0]) < bottleneck || d(ends[1]) < bottleneck) continue;
    const Diagram diagram(world, bottleneck, ends);
    const PlainCosts costs(diagram, cells, ends[0]);
    const auto path = diagram.shortest(ends[0], ends[1]);
    EXPECT_EQ(path.empty(), !costs.reached(ends[1]));
    if (path.empty()) continue;
    EXPECT_TRUE(path.front() == ends[0] && path.back() == ends[1]);
    for (std::size_t i = path.size() - 1; i > 0; --i)
      EXPECT_TRUE(path[i - 1] == best_predecessor(diagram, world, costs, path[i])) << "step " << i;
    bridged += std::any_of(path.begin(), path.end(),
                           [&](const GridCell& c) { return !diagram.contains(c); });
  }
  return bridged;
}

TEST(DiagramSearch, TakesTheRoomiestOfTheShortestPaths) {
  RandomEngine random(21);
  int bridged = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const World world = random_world(random, 3, uniform_int(random, 3, 12));
    // In cells of 0.05 m: narrow enough for steps beside occupied cells, and wider.
    for (const double bottleneck : {0.01, 0.06, 0.1, 0.2})
      bridged += compare_paths(random, world, bottleneck);
  }
  EXPECT_GT(bridged, 100);
}

}  // namespace
}  // namespace slalom
