// SPDX-License-Identifier: BSD-3-Clause
#include "arrival/safe_interval_search.h"

#include <slalom/core/distance.h>
#include <slalom/core/random.h>
#include <slalom/trajectory/path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom::arrival {
namespace {

using mrpt::math::TPoint2D;

constexpr double kSearchSpeed = 1;     // m/s
constexpr double kSearchHorizon = 12;  // s

/// A lattice of 5 x 5 points 1 m apart, of which some are missing, with movers.
struct SearchWorld {
  Path nodes;
  Roadmap roadmap;
  Movers movers;
  Traffic traffic;
};

/// The goal is node 1.
void complete(Roadmap& roadmap) {
  roadmap.is_goal = [](int node) { return node == 1; };
  roadmap.rest = [position = roadmap.position](int node) {
    return distance_between(position(node), position(1));
  };
}

SearchWorld random_search_world(RandomEngine& engine) {
  SearchWorld world;
  world.nodes = {{0, 0}, {4, 4}};
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x)
      if (x + y != 0 && x + y != 8 && uniform_int(engine, 0, 9) < 7) world.nodes.emplace_back(x, y);
  world.roadmap.position = [nodes = world.nodes](int node) {
    return nodes[static_cast<std::size_t>(node)];
  };
  world.roadmap.neighbors = [nodes = world.nodes](int node) {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
      if (i != node && distance_between(nodes[static_cast<std::size_t>(i)],
                                        nodes[static_cast<std::size_t>(node)]) < 1.5)
        found.push_back(i);
    return found;
  };
  complete(world.roadmap);
  const int count = uniform_int(engine, 1, 6);
  for (int i = 0; i < count; ++i) {
    Mover mover{std::to_string(i),
                uniform_real(engine, 0.3, 0.9),
                {},
                static_cast<MoverEnd>(uniform_int(engine, 0, 2))};
    double t = uniform_real(engine, 0, 2);
    const int points = uniform_int(engine, 1, 4);
    for (int p = 0; p < points; ++p, t += uniform_real(engine, 0.5, 3))
      mover.waypoints.push_back({t, {uniform_real(engine, -1, 5), uniform_real(engine, -1, 5)}});
    if (mover.after == MoverEnd::Loop)
      mover.waypoints.push_back({t + 1, mover.waypoints.front().position});
    world.movers.push_back(mover);
  }
  world.traffic = traffic_of(world.movers, 0, kSearchHorizon);
  return world;
}

/// Whether the robot keeps its distances moving from p at t0 to q at t1 (at most at one of these
/// times by less), by sampling.
bool keeps_distance(const SearchWorld& world, const TPoint2D& p, double t0, const TPoint2D& q,
                    double t1, double tolerance) {
  const int samples = 1 + static_cast<int>((t1 - t0) / 0.01);
  for (int i = 0; i <= samples; ++i) {
    const double part = static_cast<double>(i) / samples, t = t0 + part * (t1 - t0);
    const TPoint2D robot = p + (q - p) * part;
    for (std::size_t m = 0; m < world.movers.size(); ++m)
      if (world.movers[m].present(t) &&
          distance_between(robot, world.movers[m].position(t)) < world.movers[m].radius - tolerance)
        return false;
  }
  return true;
}

/// The earliest arrival among departures at multiples of `step`, by exhaustion; infinity if there
/// is none.
double exhaustive_arrival(const SearchWorld& world, double step) {
  const auto node = [&](int i) { return world.nodes[static_cast<std::size_t>(i)]; };
  std::set<std::pair<double, int>> reached{{0, 0}}, done;
  while (!reached.empty()) {
    const auto [t, at] = *reached.begin();
    reached.erase(reached.begin());
    if (at == 1) return t;
    if (t > kSearchHorizon || !done.emplace(t, at).second) continue;
    const double wait = (std::floor(t / step + 1e-6) + 1) * step;
    if (keeps_distance(world, node(at), t, node(at), wait, 0)) reached.emplace(wait, at);
    for (const int next : world.roadmap.neighbors(at)) {
      const double arrival = t + distance_between(node(at), node(next)) / kSearchSpeed;
      const double rounded = std::ceil(arrival / step - 1e-6) * step;
      if (rounded <= kSearchHorizon && keeps_distance(world, node(at), t, node(next), arrival, 0) &&
          keeps_distance(world, node(next), arrival, node(next), rounded, 0))
        reached.emplace(rounded, next);
    }
  }
  return INFINITY;
}

TEST(SafeIntervals, FindTheEarliestArrivalThatExhaustionApproaches) {
  RandomEngine engine(42);
  int solved = 0, waiting = 0, unsolved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const SearchWorld world = random_search_world(engine);
    const auto stays =
        search_safe_intervals(world.roadmap, world.traffic, kSearchSpeed, kSearchHorizon);
    constexpr double kStep = 0.5;
    const double exhaustive = exhaustive_arrival(world, kStep);
    if (stays.empty()) {
      ASSERT_EQ(exhaustive, INFINITY) << trial;
      ++unsolved;
      continue;
    }
    ++solved;
    ASSERT_EQ(stays.front().node, 0);
    ASSERT_EQ(stays.back().node, 1);
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const TPoint2D here = world.nodes[static_cast<std::size_t>(stays[i].node)];
      ASSERT_TRUE(keeps_distance(world, here, stays[i].arrival, here, stays[i].departure, 1e-9))
          << trial;
      waiting += stays[i].departure - stays[i].arrival > 0.01 ? 1 : 0;
      if (i + 1 == stays.size()) break;
      const TPoint2D next = world.nodes[static_cast<std::size_t>(stays[i + 1].node)];
      ASSERT_NEAR(stays[i + 1].arrival - stays[i].departure,
                  distance_between(here, next) / kSearchSpeed, 1e-12);
      ASSERT_TRUE(keeps_distance(world, here, stays[i].departure, next, stays[i + 1].arrival, 1e-9))
          << trial;
    }
    ASSERT_LE(stays.back().arrival, exhaustive + 1e-9) << trial;
  }
  EXPECT_GT(solved, 80);
  EXPECT_GT(waiting, 30);
  EXPECT_GT(unsolved, 5);
}

TEST(SafeIntervals, LetADoorwayBePassedAfterAMoverHasCrossedIt) {
  // From (0, 0) over (2, 0) to (4, 0). A mover of distance 0.5 m waits at (2, 0) until t = 7 and
  // goes up at 1 m/s: the edge to (2, 0) may be left such that the robot arrives when it is 0.5 m
  // away, and in between it recedes: at 7.5 at the earliest if the robot meets the mover's line
  // there.
  const Path nodes{{0, 0}, {4, 0}, {2, 0}};
  Roadmap roadmap;
  roadmap.position = [&](int node) { return nodes[static_cast<std::size_t>(node)]; };
  roadmap.neighbors = [](int node) {
    return node == 2 ? std::vector<int>{0, 1} : std::vector<int>{2};
  };
  complete(roadmap);
  const Mover mover{"a", 0.2, {{0, {2, 0}}, {7, {2, 0}}, {17, {2, 10}}}, MoverEnd::Vanish};
  const auto stays = search_safe_intervals(roadmap, traffic_of({mover}, 0.3, 20), 1, 20);
  ASSERT_EQ(stays.size(), 3U);
  // Before the robot arrives at (2, 0) at the time a, the distance at the time t > 7 is hypot(a -
  // t, t - 7), least at t = (a + 7) / 2: (a - 7) / sqrt(2) >= 0.5.
  EXPECT_NEAR(stays[1].arrival, 7 + 0.5 * std::sqrt(2), 1e-6);
  EXPECT_NEAR(stays[2].arrival, 9 + 0.5 * std::sqrt(2), 1e-6);
  EXPECT_TRUE(search_safe_intervals(roadmap, traffic_of({mover}, 0.3, 9), 1, 9).empty())
      << "later than the horizon";
}

}  // namespace
}  // namespace slalom::arrival
