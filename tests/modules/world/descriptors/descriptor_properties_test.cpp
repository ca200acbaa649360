// SPDX-License-Identifier: BSD-3-Clause
// Invariants of all scenarios, tested on random scenarios by RapidCheck.
#include "small_worlds.h"

#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace slalom {
namespace {

/// A small grid: cells of 0.5 m, start and goal in free corners.
using Cells = std::vector<std::vector<bool>>;

Cells random_cells() {
  const int size_x = *rc::gen::inRange(3, 12), size_y = *rc::gen::inRange(3, 12);
  Cells cells;
  for (int y = 0; y < size_y; ++y)
    cells.push_back(*rc::gen::container<std::vector<bool>>(
        static_cast<std::size_t>(size_x), rc::gen::weightedElement<bool>({{3, false}, {1, true}})));
  cells.front().front() = cells.back().back() = false;
  return cells;
}

World world_of(const Cells& cells, double x = 0, double y = 0) {
  const int size_x = static_cast<int>(cells[0].size()), size_y = static_cast<int>(cells.size());
  mrpt::maps::COccupancyGridMap2D map = make_grid_map(size_x, size_y, 0.5, {x, y});
  for (int cy = 0; cy < size_y; ++cy)
    for (int cx = 0; cx < size_x; ++cx)
      map.setCell(cx, cy,
                  cells[static_cast<std::size_t>(cy)][static_cast<std::size_t>(cx)] ? 0.0F : 1.0F);
  return {Scenario::grid("drawn", map, {x + 0.25, y + 0.25, 0},
                         {x + 0.5 * size_x - 0.25, y + 0.5 * size_y - 0.25}),
          0.5};
}

/// All descriptors except those of BARN, which have a grid of their own, and of movers.
std::vector<std::string> static_descriptor_ids() {
  std::vector<std::string> ids;
  for (const std::string& id : descriptor_ids())
    if (id.find("barn_") != 0 && !contains(mover_descriptor_ids(), id)) ids.push_back(id);
  return ids;
}

/// A straight path regardless of obstacles: path descriptors are defined for any path.
DescriptorContext with_straight_path(const World& world) {
  const auto& start = world.scenario().start();
  return context_with_path(world, {{start.x, start.y}, world.scenario().goal()}, 0.25, 2);
}

/// At up to three positions in the world of the cells, for 20 s.
Movers random_movers() {
  Movers movers;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const auto point = [] {
      return mrpt::math::TPoint2D(0.1 * *rc::gen::inRange(0, 60), 0.1 * *rc::gen::inRange(0, 60));
    };
    movers.push_back({"m" + std::to_string(i), 0.3, {{0, point()}, {20, point()}}, MoverEnd::Stop});
  }
  return movers;
}

RC_GTEST_PROP(DescriptorProperties, ValuesAreInTheRangesThatTheirRowsState, ()) {
  constexpr double kRounding = 1e-9;
  const World grid = world_of(random_cells());
  const World world(grid.scenario().with_movers(random_movers()), 0.5);
  const DescriptorContext context = with_straight_path(world);
  for (const Descriptor& tested : all_descriptors()) {
    const Value value = tested.compute(context);
    if (value.is_na()) continue;
    RC_LOG() << tested.info.id << " " << value.number() << "\n";
    RC_ASSERT(value.number() >= tested.info.range.low - kRounding);
    RC_ASSERT(value.number() <= tested.info.range.high + kRounding);
    if (tested.info.id == "bottleneck_width") RC_ASSERT(value.number() >= 0.5 - 1e-6);
    if (tested.info.id.find("clearance_") == 0) RC_ASSERT(value.number() >= 0.25 - 1e-6);
  }
}

RC_GTEST_PROP(DescriptorProperties, OnlyTheseCanBeNaWhereTheRobotFits, ()) {
  const World world = world_of(random_cells());
  const DescriptorContext context = with_straight_path(world);
  for (const std::string& id : static_descriptor_ids()) {
    if (id == "bottleneck_width" || id == "clustering") continue;  // no path, no obstacles
    RC_ASSERT(!descriptor(id).compute(context).is_na());
  }
}

RC_GTEST_PROP(DescriptorProperties, AreInvariantUnderTranslationByWholeCells, ()) {
  const Cells cells = random_cells();
  const World here = world_of(cells);
  const World there =
      world_of(cells, 0.5 * *rc::gen::inRange(-40, 40), 0.5 * *rc::gen::inRange(-40, 40));
  for (const std::string& id : static_descriptor_ids()) {
    const Value a = descriptor(id).compute(with_straight_path(here));
    const Value b = descriptor(id).compute(with_straight_path(there));
    RC_ASSERT(a.is_na() == b.is_na());
    RC_LOG() << id << "\n";
    // A ray on the border of two cells may be traced through either: a few of 64.
    const double tolerance = id.find("confinement") == 0 ? 0.02 : 1e-6;
    if (!a.is_na()) RC_ASSERT(std::abs(a.number() - b.number()) <= tolerance);
  }
}

RC_GTEST_PROP(DescriptorProperties, AreInvariantUnderTranslationOfContinuousScenarios, ()) {
  const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));
  const int discs = *rc::gen::inRange(0, 15);
  const double x = 0.0137 * *rc::gen::inRange(-10000, 10000);
  const double y = 0.0137 * *rc::gen::inRange(-10000, 10000);
  const World here(random_room(seed, discs), 0.2);
  const World there(random_room(seed, discs, {x, y}), 0.2);
  // Rounding of coordinates may change one of the 2500 cells, where a disc just touches it.
  for (const std::string id : {"density", "cspace_density", "clearness", "occupancy_entropy"})
    RC_ASSERT(std::abs(value_of(id, context_of(here)) - value_of(id, context_of(there))) < 5e-3);
}

RC_GTEST_PROP(DescriptorProperties, AnAdditionalObstacleNeverDecreasesDensityOrIncreasesClearness,
              ()) {
  Cells cells = random_cells();
  const World before = world_of(cells);
  std::vector<std::pair<std::size_t, std::size_t>> candidates;
  for (std::size_t y = 0; y < cells.size(); ++y)
    for (std::size_t x = 0; x < cells[0].size(); ++x)
      if (!cells[y][x] && x + y > 0 && x + y + 2 < cells[0].size() + cells.size())
        candidates.emplace_back(x, y);
  RC_PRE(!candidates.empty());
  const auto [x, y] = *rc::gen::elementOf(candidates);
  cells[y][x] = true;
  const World after = world_of(cells);
  const auto change = [&](const std::string& id) {
    return value_of(id, with_straight_path(after)) - value_of(id, with_straight_path(before));
  };
  RC_ASSERT(change("density") > 0);
  RC_ASSERT(change("cspace_density") > 0);
  RC_ASSERT(change("narrow_fraction") >= 0);
  RC_ASSERT(change("goal_visibility") <= 0);
  RC_ASSERT(change("traversability") <= 1e-9);
  // Means over F, which shrinks, are not monotonic; their integral is.
  const auto integral = [](const World& world, const std::string& id) {
    return value_of(id, with_straight_path(world)) *
           (1 - value_of("density", with_straight_path(world)));
  };
  for (const std::string id : {"clearness", "clearness_mean_distance"})
    RC_ASSERT(integral(after, id) < integral(before, id));
  const Value wide = descriptor("bottleneck_width").compute(with_straight_path(before));
  const Value narrow = descriptor("bottleneck_width").compute(with_straight_path(after));
  if (!narrow.is_na()) RC_ASSERT(wide.number() >= narrow.number());
}

RC_GTEST_PROP(DescriptorProperties, ALargerRobotHasLessFreeSpace, ()) {
  const World world = world_of(random_cells());
  double occupied = 0, clearance = 0;
  for (const double radius : {0.1, 0.25, 0.5, 0.75}) {
    const DescriptorContext context = context_of(world, radius, 2);
    RC_ASSERT(value_of("cspace_density", context) >= occupied);
    occupied = value_of("cspace_density", context);
    const Value quantile = descriptor("clearance_q05").compute(context);
    const Value mean = descriptor("clearance_mean").compute(context);
    if (mean.is_na()) break;
    RC_ASSERT(mean.number() >= clearance - 1e-9);
    RC_ASSERT(quantile.number() <= mean.number() + 1e-6);
    clearance = mean.number();
  }
}

RC_GTEST_PROP(DescriptorProperties, APolygonIsBoundedByItsInscribedAndEnclosingDiscs, ()) {
  const World world = world_of(random_cells());
  DescriptorContext context = context_of(world);
  const double length = 0.01 * *rc::gen::inRange(10, 90), width = 0.01 * *rc::gen::inRange(10, 90);
  const std::string x = std::to_string(length), y = std::to_string(width);
  context.robot = Footprint::parse("-" + x + ",-" + y + ";" + x + ",-" + y + ";" + x + "," + y +
                                   ";-" + x + "," + y);
  const double polygon = value_of("cspace_density", context);
  RC_ASSERT(polygon >= value_of("cspace_density", context_of(world, std::min(length, width))));
  RC_ASSERT(polygon <= value_of("cspace_density", context_of(world, std::hypot(length, width))));
}

RC_GTEST_PROP(DescriptorProperties, ExactConfinementIncreasesWithTheRange, ()) {
  const World world = world_of(random_cells());
  double before = 0;
  for (const double range : {0.3, 0.5, 1.0, 2.0, 10.0}) {
    DescriptorContext context = context_of(world, 0.25, range);
    context.exact_confinement = true;
    const double value = value_of("confinement", context);
    RC_ASSERT(value >= before - 1e-12);
    before = value;
  }
  RC_ASSERT(std::abs(before - 1) < 1e-12);  // 10 m reach all walls
}

}  // namespace
}  // namespace slalom
