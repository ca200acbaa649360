// SPDX-License-Identifier: BSD-3-Clause
#include "arrival/arrival_bound.h"
#include "reference_worlds.h"

#include <slalom/core/distance.h>
#include <slalom/references/earliest_arrival.h>
#include <slalom/references/exact_shortest.h>
#include <slalom/trajectory/path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kArrivalRadius = 0.25;  // m
constexpr double kGoalTolerance = 0.2;   // m
constexpr double kArrivalSpeed = 0.5;    // m/s

World with_movers(const World& world, const Movers& movers) {
  return {world.scenario().with_movers(movers), world.requested_resolution()};
}

ShortestPath shortest_in(const World& world) {
  std::string reason;
  return *exact_shortest_path(problem_of(world, kArrivalRadius), reason);
}

std::optional<EarliestArrival> arrival_in(const World& world, double max_time,
                                          std::string* why = nullptr) {
  std::string reason;
  const auto arrival = earliest_arrival(problem_of(world, kArrivalRadius), shortest_in(world),
                                        {kArrivalSpeed, kGoalTolerance, max_time}, reason);
  if (why != nullptr) *why = reason;
  return arrival;
}

/// The lower bound without help from the upper one.
double lower_bound_in(const World& world, double max_time) {
  const PlanningProblem problem = problem_of(world, kArrivalRadius);
  const ArrivalLimits limits{kArrivalSpeed, kGoalTolerance, max_time};
  return arrival::moving_bound(problem, limits,
                               earliest_without_movers(problem, shortest_in(world), limits),
                               std::numeric_limits<double>::infinity());
}

/// Checks the plan by sampling.
void expect_feasible(const World& world, const EarliestArrival& arrival) {
  const auto& plan = arrival.plan;
  for (std::size_t i = 1; i < plan.size(); ++i) {
    const auto &a = plan[i - 1], &b = plan[i];
    ASSERT_LE(distance_between(a.position, b.position), kArrivalSpeed * (b.t - a.t) + 1e-9);
    ASSERT_TRUE(is_free(world, {a.position, b.position}, kArrivalRadius));
    const int samples = 1 + static_cast<int>((b.t - a.t) / 0.01);
    for (int s = 0; s <= samples; ++s) {
      const double part = static_cast<double>(s) / samples, t = a.t + (b.t - a.t) * part;
      const TPoint2D robot = a.position + (b.position - a.position) * part;
      for (const Mover& mover : world.scenario().movers())
        if (mover.present(t)) {
          ASSERT_GE(distance_between(robot, mover.position(t)),
                    kArrivalRadius + mover.radius - 1e-9)
              << t;
        }
    }
  }
  EXPECT_EQ(plan.front().t, 0);
  EXPECT_EQ(plan.back().t, arrival.certificate.upper_bound);
  EXPECT_LE(distance_between(plan.back().position, world.scenario().goal()), kGoalTolerance);
}

Movers random_movers(RandomEngine& engine, int count, double low, double high) {
  Movers movers;
  for (int i = 0; i < count; ++i) {
    const auto point = [&] {
      return TPoint2D(uniform_real(engine, low, high), uniform_real(engine, low, high));
    };
    const TPoint2D first = point();
    movers.push_back({std::to_string(i),
                      uniform_real(engine, 0.1, 0.6),
                      {{0, first}, {6, point()}, {12, point()}, {20, first}},
                      static_cast<MoverEnd>(uniform_int(engine, 0, 2))});
  }
  return movers;
}

TEST(EarliestArrival, WithoutMoversIsThatOfTheShortestPath) {
  RandomEngine engine(51);
  int solved = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const World world = random_world(engine, 10, 12);
    std::string reason;
    const auto shortest = exact_shortest_path(problem_of(world, kArrivalRadius), reason);
    const auto& goal = world.scenario().goal();
    if (!shortest || world.distance_field().clearance(goal) < kArrivalRadius + kGoalTolerance)
      continue;
    ++solved;
    const auto arrival = arrival_in(world, 1000);
    ASSERT_TRUE(arrival.has_value());
    const Certificate& bounds = arrival->certificate;
    // Around a free goal the shortest path is straight.
    EXPECT_EQ(bounds.lower_bound, (shortest->exact_length - kGoalTolerance) / kArrivalSpeed);
    EXPECT_LE(bounds.upper_bound, bounds.lower_bound * (1 + 1.1e-6)) << trial;
    expect_feasible(world, *arrival);
  }
  EXPECT_GT(solved, 5);
}

TEST(EarliestArrival, IsNotAfterWhatAWallNextToTheGoalAllows) {
  // The goal is 0.3 m from a wall of cells: the region is cut by what the robot cannot enter.
  const World world = empty_world(6, {1, 1}, {5.7, 3});
  const auto arrival = arrival_in(world, 100);
  ASSERT_TRUE(arrival.has_value());
  const double straight = (std::hypot(4.7, 2) - kGoalTolerance) / kArrivalSpeed;
  EXPECT_NEAR(arrival->certificate.lower_bound, straight, 1e-9);
  EXPECT_NEAR(arrival->certificate.upper_bound, straight, 1e-6);
}

TEST(EarliestArrival, IsAtOnceInTheGoalRegion) {
  const auto arrival = arrival_in(empty_world(6, {3, 3}, {3.15, 3}), 100);
  ASSERT_TRUE(arrival.has_value());
  EXPECT_EQ(arrival->certificate.lower_bound, 0);
  EXPECT_EQ(arrival->certificate.upper_bound, 0);
}

TEST(EarliestArrival, WaitsForAMoverInADoorway) {
  // The wall at x = 5 has a door about 0.7 m wide, in which a mover stands for 30 s; it then
  // vanishes. The robot waits in front of it, at least 0.25 + 0.3 m from its center.
  const World world = with_movers(walled_world(10, 0.8),
                                  {{"a", 0.3, {{0, {5, 5}}, {30, {5, 5}}}, MoverEnd::Vanish}});
  const auto arrival = arrival_in(world, 200);
  ASSERT_TRUE(arrival.has_value());
  expect_feasible(world, *arrival);
  const double from_door = (std::hypot(4, 3) - kGoalTolerance) / kArrivalSpeed,
               to_door = 0.55 / kArrivalSpeed;
  EXPECT_GT(arrival->certificate.upper_bound, 30 + from_door);
  EXPECT_LT(arrival->certificate.upper_bound, 30 + from_door + to_door + 0.5);
  EXPECT_GT(arrival->certificate.lower_bound, 30 + from_door - 0.1 / kArrivalSpeed);
}

TEST(EarliestArrival, IsNotBeforeTheGoalIsFree) {
  const Mover mover{"a", 0.5, {{0, {9, 5}}, {60, {9, 5}}}, MoverEnd::Vanish};
  const World world = with_movers(empty_world(10, {1, 5}, {9, 5}), {mover});
  const auto arrival = arrival_in(world, 100);
  ASSERT_TRUE(arrival.has_value());
  // The robot waits 0.75 m from the goal; of the 0.55 m to the region the smaller disc saves less
  // than 0.06 m twice.
  EXPECT_GT(arrival->certificate.lower_bound, 60 + 0.43 / kArrivalSpeed);
  EXPECT_GE(arrival->certificate.upper_bound, 60 + 0.55 / kArrivalSpeed - 1e-6);
  EXPECT_LT(arrival->certificate.upper_bound, 60 + 0.55 / kArrivalSpeed + 0.5);
  expect_feasible(world, *arrival);
}

TEST(EarliestArrival, LiesBetweenItsBoundsAmongManyMovers) {
  RandomEngine engine(52);
  int later = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const World world =
        with_movers(empty_world(10, {1, 1}, {9, 9}), random_movers(engine, 5 + 6 * trial, 2.5, 8));
    const auto arrival = arrival_in(world, 100);
    ASSERT_TRUE(arrival.has_value());
    expect_feasible(world, *arrival);
    const Certificate& bounds = arrival->certificate;
    EXPECT_LE(lower_bound_in(world, 100), bounds.upper_bound) << trial;
    EXPECT_GE(bounds.lower_bound, (std::hypot(8, 8) - kGoalTolerance) / kArrivalSpeed - 1e-9);
    EXPECT_LT(bounds.gap(), 0.3) << trial;
    later += bounds.gap() > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(later, 2);
}

TEST(EarliestArrival, IsNotBeforeTheLowerBoundAmongDiscsAndMovers) {
  RandomEngine engine(53);
  int solved = 0, waiting = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const World world = with_movers(random_world(engine, 6, 7), random_movers(engine, 8, 0.8, 5.2));
    std::string reason;
    if (!exact_shortest_path(problem_of(world, kArrivalRadius), reason)) continue;
    const auto arrival = arrival_in(world, 40);
    const double lower = lower_bound_in(world, 40);
    if (!arrival) {
      EXPECT_EQ(lower, std::numeric_limits<double>::infinity());
      continue;
    }
    EXPECT_LE(lower, arrival->certificate.upper_bound) << trial;
    if (arrival->plan.empty()) continue;
    ++solved;
    const double direct = (shortest_in(world).exact_length - kGoalTolerance) / kArrivalSpeed;
    waiting += arrival->certificate.lower_bound > direct + 0.1 ? 1 : 0;
    expect_feasible(world, *arrival);
  }
  EXPECT_GT(solved, 10);
  EXPECT_GT(waiting, 0);
}

TEST(EarliestArrival, DoesNotDependOnTheOrderOfMovers) {
  RandomEngine engine(54);
  Movers movers = random_movers(engine, 12, 2, 8);
  const World world = empty_world(10, {1, 1}, {9, 9});
  const auto arrival = arrival_in(with_movers(world, movers), 100);
  std::reverse(movers.begin(), movers.end());
  const auto reversed = arrival_in(with_movers(world, movers), 100);
  EXPECT_EQ(arrival->certificate.lower_bound, reversed->certificate.lower_bound);
  EXPECT_EQ(arrival->certificate.upper_bound, reversed->certificate.upper_bound);
}

TEST(EarliestArrival, SaysWhyThereIsNone) {
  const World world = empty_world(10, {1, 5}, {9, 5});
  std::string reason;
  EXPECT_FALSE(arrival_in(with_movers(world, {{"a", 0.3, {{0, {1.2, 5}}}}}), 100, &reason));
  EXPECT_EQ(reason, "a moving obstacle touches the robot where it starts");
  EXPECT_FALSE(arrival_in(with_movers(world, {{"a", 0.6, {{0, {9, 5}}}}}), 100, &reason));
  EXPECT_EQ(reason, "there is no arrival among the moving obstacles within 100 s");
  const World walled = with_movers(walled_world(10, 0.8), {{"a", 0.3, {{0, {5, 5}}}}});
  EXPECT_FALSE(arrival_in(walled, 100, &reason));
  EXPECT_EQ(reason, "there is no arrival among the moving obstacles within 100 s");
  EXPECT_FALSE(arrival_in(world, 15.5, &reason));  // it takes (8 - 0.2) / 0.5 s
  EXPECT_EQ(reason, "the goal cannot be reached within 15.5 s, even without moving obstacles");
}

TEST(EarliestArrival, IsNeitherFoundNorDisprovedWhereOnlyTheSmallerDiscPasses) {
  // Beside a mover at rest there are 0.47 m to the wall on either side: too little for the robot of
  // 0.5 m, enough for one that is smaller by half the diagonal of a square.
  const World world =
      with_movers(empty_world(4, {0.5, 0.5}, {3.5, 3.5}), {{"a", 1.53, {{0, {2, 2}}}}});
  const auto arrival = arrival_in(world, 60);
  ASSERT_TRUE(arrival.has_value());
  EXPECT_TRUE(arrival->plan.empty());
  EXPECT_EQ(arrival->certificate.upper_bound, std::numeric_limits<double>::infinity());
  EXPECT_GE(arrival->certificate.lower_bound,
            (std::hypot(3, 3) - kGoalTolerance) / kArrivalSpeed - 1e-9);
}

}  // namespace
}  // namespace slalom
