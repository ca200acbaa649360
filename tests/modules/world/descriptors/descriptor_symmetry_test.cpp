// SPDX-License-Identifier: BSD-3-Clause
// The laws of every registered descriptor: the value depends on the cells, not on where they lie,
// how they are turned or as what they are given.
#include "small_worlds.h"

#include <slalom/generation/generator.h>
#include <slalom/generation/walkers.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/scenario/convert.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kSampleCell = 0.05;  ///< m, of the samples

/// Differences that values may have, relative to those above 1.
struct Tolerance {
  double moved;   ///< as a grid, and moved by whole cells
  double turned;  ///< turned or mirrored
};

/// Grids hold corners and cell sizes in single precision.
constexpr Tolerance kRounding = {1e-6, 1e-6};

/// Tolerances of descriptors that a law holds for less exactly, with the reason; all others have
/// kRounding.
const std::map<std::string, Tolerance> kTolerances = {
    // Sampled to a standard error of 0.005 at points that are not turned with the cells.
    {"confinement", {1e-6, 0.01}},
    // The fan of rays turns counter-clockwise from point to point of the path.
    {"confinement_path", {1e-6, 0.005}},
    // Steps to two neighbors that are equally close to the goal: the one in x is taken.
    {"trap_fraction", {1e-6, 0.001}},
    // A ray that grazes the disc of a mover ends there or some meters later: one of 3200 at one
    // instant.
    {"dynamic_traversability", {1e-3, 1e-3}},
    // Blocks of 1 m begin at the lower left corner, and are cut at the opposite sides.
    {"occupancy_entropy", {1e-6, 0.01}},
    // Cells of 0.15 m begin at the lower left corner, as published.
    {"barn_closest_distance", {1e-6, 0.05}},
    {"barn_visibility", {1e-6, 0.2}},
    {"barn_characteristic_dimension", {1e-6, 0.15}},
    // The same, and rays of slope 2 or 1/2 depend on their direction, as published.
    {"barn_dispersion", {1e-6, 0.4}}};

Tolerance symmetry_tolerance(const std::string& id) {
  const auto found = kTolerances.find(id);
  return found == kTolerances.end() ? kRounding : found->second;
}

/// A symmetry of the cells: the place of a point, and the direction of a heading.
struct Placement {
  std::function<TPoint2D(const TPoint2D&)> place;
  std::function<double(double)> heading;
};

Placement moved_by(double x, double y) {
  return {[=](const TPoint2D& p) { return TPoint2D(p.x + x, p.y + y); },
          [](double heading) { return heading; }};
}

/// A quarter turn about the origin.
const Placement kTurned = {[](const TPoint2D& p) { return TPoint2D(-p.y, p.x); },
                           [](double heading) { return heading + M_PI / 2; }};
const Placement kMirrored = {[](const TPoint2D& p) { return TPoint2D(-p.x, p.y); },
                             [](double heading) { return M_PI - heading; }};

/// Rectangles within the runs of occupied cells of each row: they touch these cells only.
std::vector<Polygon> boxes_of(const Occupancy& cells) {
  constexpr double kMargin = 0.25;  // cells
  std::vector<Polygon> boxes;
  for (int y = 0; y < cells.size_y(); ++y)
    for (int first = 0, last = 0; first < cells.size_x(); first = last + 1) {
      for (last = first; last < cells.size_x() && cells.occupied(last, y);) ++last;
      if (last == first) continue;
      const double left = first + kMargin, right = last - kMargin;
      const double low = y + kMargin, high = y + 1 - kMargin;
      boxes.push_back({{cells.to_world(left, low), cells.to_world(right, low),
                        cells.to_world(right, high), cells.to_world(left, high)}});
    }
  return boxes;
}

/// The cells of a scenario, and its movers, as shapes elsewhere.
Scenario placed(const Scenario& scenario, const Placement& placement, double cell = kSampleCell) {
  const Occupancy cells = make_occupancy(scenario, cell);
  Primitives obstacles{{}, boxes_of(cells)};
  for (Polygon& box : obstacles.polygons)
    for (TPoint2D& p : box.vertices) p = placement.place(p);
  const Bounds& from = scenario.bounds();
  const TPoint2D a = placement.place({from.x_min, from.y_min});
  const TPoint2D b = placement.place({from.x_max, from.y_max});
  const Bounds bounds = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x),
                         std::max(a.y, b.y)};
  const TPose2D& start = scenario.start();
  const TPoint2D at = placement.place({start.x, start.y});
  Movers movers = scenario.movers();
  for (Mover& mover : movers)
    for (Waypoint& waypoint : mover.waypoints)
      waypoint.position = placement.place(waypoint.position);
  return Scenario::continuous(scenario.name(), bounds, obstacles,
                              {at.x, at.y, placement.heading(start.phi)},
                              placement.place(scenario.goal()))
      .with_movers(movers);
}

KnownPath symmetric_path(const World& world) {
  const auto& start = world.scenario().start();
  std::string reason;
  const auto path =
      exact_shortest_path({world, 0.25, {start.x, start.y}, world.scenario().goal()}, reason);
  return path ? KnownPath{path->path, path->length, ""} : KnownPath{{}, 0, reason};
}

std::vector<Value> all_values(const Scenario& scenario, double cell = kSampleCell) {
  const World world(scenario, cell);
  DescriptorContext context = context_of(world);
  context.shortest = search_once([&world] { return symmetric_path(world); });
  std::vector<Value> values;
  for (const Descriptor& tested : all_descriptors()) values.push_back(tested.compute(context));
  return values;
}

/// Scenarios of several families with walkers, as shapes, and their values.
struct Sample {
  Scenario scenario;
  std::vector<Value> values;
};

const std::vector<Sample>& samples() {
  static const std::vector<Sample> result = [] {
    std::vector<Sample> samples;
    for (const std::string family :
         {"random", "poisson_forest", "traps", "rooms", "maze", "perlin"}) {
      GenerationSettings settings;
      settings.count = 2;
      settings.seed = 31;
      settings.name_prefix = family;
      RandomEngine engine(settings.seed);
      WalkerOptions walkers;
      walkers.count = 3;
      for (const Scenario& made : generate_solvable(*make_generator(family, IniFile::from_text("")),
                                                    settings, *make_silent_progress())) {
        const World world(made, kSampleCell);
        const Scenario scenario =
            placed(with_walkers(world, settings.robot_radius, walkers, engine), moved_by(0, 0));
        samples.push_back({scenario, all_values(scenario)});
      }
    }
    return samples;
  }();
  return result;
}

void expect_equal(const Sample& expected, const Scenario& scenario, double Tolerance::*kind) {
  const std::vector<Value> values = all_values(scenario);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& id = all_descriptors()[i].info.id;
    const Value &a = expected.values[i], &b = values[i];
    ASSERT_EQ(a.is_na(), b.is_na()) << id << " of " << scenario.name();
    if (a.is_na()) continue;
    const double scale = std::max(1.0, std::abs(a.number()));
    EXPECT_NEAR(a.number(), b.number(), scale * (symmetry_tolerance(id).*kind))
        << id << " of " << scenario.name();
  }
}

TEST(DescriptorSymmetry, ShapesAndGridsOfTheSameCellsAgree) {
  for (const double cell : {0.025, 0.05, 0.1})
    for (const Sample& sample : samples()) {
      const Scenario shapes = placed(sample.scenario, moved_by(0, 0), cell);
      expect_equal({shapes, all_values(shapes, cell)}, convert(shapes, Representation::Grid, cell),
                   &Tolerance::moved);
    }
}

TEST(DescriptorSymmetry, ValuesDoNotDependOnTranslationsByWholeCells) {
  for (const Sample& sample : samples())
    for (const auto& [x, y] : {std::pair(5, 7), std::pair(-301, 13), std::pair(2, 999)})
      expect_equal(sample, placed(sample.scenario, moved_by(x * kSampleCell, y * kSampleCell)),
                   &Tolerance::moved);
}

TEST(DescriptorSymmetry, ValuesDoNotDependOnQuarterTurns) {
  for (const Sample& sample : samples()) {
    Scenario turned = sample.scenario;
    for (int quarters = 1; quarters < 4; ++quarters) {
      turned = placed(turned, kTurned);
      expect_equal(sample, turned, &Tolerance::turned);
    }
  }
}

TEST(DescriptorSymmetry, ValuesDoNotDependOnMirrors) {
  for (const Sample& sample : samples()) {
    const Scenario mirrored = placed(sample.scenario, kMirrored);
    expect_equal(sample, mirrored, &Tolerance::turned);
    expect_equal(sample, placed(mirrored, kTurned), &Tolerance::turned);
  }
}

}  // namespace
}  // namespace slalom
