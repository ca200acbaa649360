// SPDX-License-Identifier: BSD-3-Clause
// No run is shorter than the shortest path: tested by RapidCheck on random grids and trajectories.
#include <slalom/core/distance.h>
#include <slalom/metrics/metric.h>
#include <slalom/references/disc_path.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kCell = 0.25, kRadius = 0.25, kTolerance = 1;  // m

/// A grid of 5 m x 5 m with scattered cells, free in the corners of start and goal, so that some
/// passages are exactly as wide as the robot.
World scattered_world() {
  constexpr int kCells = 20;
  mrpt::maps::COccupancyGridMap2D map = make_grid_map(kCells, kCells, kCell, {0, 0});
  const int count = *rc::gen::inRange(5, 40);
  for (int i = 0; i < count; ++i) {
    const int x = *rc::gen::inRange(0, kCells), y = *rc::gen::inRange(0, kCells);
    const bool is_corner = std::min(x, y) < 4 ? std::max(x, y) < 4 : std::min(x, y) >= kCells - 4;
    if (!is_corner) map.setCell(x, y, 0.0F);
  }
  return {Scenario::grid("scattered", map, {0.5, 0.5, 0}, {4.5, 4.5}), kCell};
}

double random_number(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1000001) * 1e-6);
}

TPoint2D start_of(const World& world) {
  return {world.scenario().start().x, world.scenario().start().y};
}

/// Appends the shortest path to a point; its length along arcs is recorded. False if there is none.
bool drive_to(const World& world, const TPoint2D& to, Trajectory& run) {
  const Sample last = run.samples.back();
  std::string reason;
  const auto path = shortest_disc_path(world.occupancy(), kRadius, TPoint2D(last.pose), to, reason);
  if (!path) return false;
  for (const TPoint2D& p : to_polyline(*path, world.occupancy())) {
    Sample sample = last;
    sample.t = 0.1 * static_cast<double>(run.samples.size());
    sample.pose = {p.x, p.y, 0};
    run.samples.push_back(sample);
  }
  run.samples.back().traveled += path->length;
  return true;
}

/// The points of the shortest path at which a run may end.
std::vector<TPoint2D> ends_along(const Path& shortest) {
  std::vector<TPoint2D> ends;
  for (const TPoint2D& p : resample(shortest, 0.01))
    if (distance_between(p, shortest.back()) <= kTolerance) ends.push_back(p);
  return ends;
}

/// A run over some random points to one near the goal: any, or one on the shortest path.
Trajectory random_run(const World& world, const Path& shortest) {
  Trajectory run;
  run.samples.resize(1);
  run.samples[0].pose = world.scenario().start();
  run.samples[0].traveled = 0;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
    drive_to(world, {random_number(0, 5), random_number(0, 5)}, run);
  const double away = random_number(0, kTolerance), angle = random_number(-M_PI, M_PI);
  const TPoint2D goal = shortest.back();
  const bool is_anywhere = *rc::gen::arbitrary<bool>();
  if (is_anywhere &&
      drive_to(world, {goal.x + away * std::cos(angle), goal.y + away * std::sin(angle)}, run))
    return run;
  RC_ASSERT(drive_to(world, *rc::gen::elementOf(ends_along(shortest)), run));
  return run;
}

RC_GTEST_PROP(OptimalityProperties, NoSuccessfulRunIsAboveOne, ()) {
  const World world = scattered_world();
  References references;
  references.shortest = exact_shortest_path(
      {world, kRadius, start_of(world), world.scenario().goal()}, references.shortest_reason);
  RC_PRE(references.shortest.has_value());
  const Trajectory run = random_run(world, references.shortest->path);
  RobotModel robot;
  robot.radius = kRadius;
  const MetricContext context =
      make_metric_context(world, robot, run, Outcome::Success, references, 60, kTolerance);
  RC_ASSERT(metric("optimality").compute(context).number() <= 1);
  RC_ASSERT(metric("path_excess").compute(context).number() >= 0);
  RC_ASSERT(bound_violation(context).empty());
  // A bound above the length of the run is contradicted by it.
  const double optimality = metric("optimality").compute(context).number();
  references.shortest->exact_length *= 1.001 / optimality;
  RC_ASSERT(!bound_violation(context).empty());
  RC_ASSERT(metric("optimality").compute(context).number() > 1);
}

}  // namespace
}  // namespace slalom
