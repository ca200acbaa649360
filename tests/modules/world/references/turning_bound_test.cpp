// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/random.h>
#include <slalom/references/turning_bound.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kTurningRadius = 0.5;  // m

World room(const Primitives& obstacles = {}) {
  return {Scenario::continuous("room", {0, 0, 10, 10}, obstacles, {5, 5, 0}, {9, 9}), 0.05};
}

PlanningProblem problem(const World& world, double heading, const mrpt::math::TPoint2D& goal) {
  return {world, 0.25, {5, 5}, goal, heading};
}

double bound(const PlanningProblem& problem, bool reversible) {
  const References exact = compute_references(problem, nullptr, 0.01, 1);
  return turning_lower_bound(problem, exact.shortest.value(), kTurningRadius, reversible);
}

TEST(TurningBound, WithoutObstaclesIsTheArcAndTheTangentToTheGoal) {
  const World world = room();
  // Heading 0, goal 3 m to the left: the circle's center is 0.5 m to the left, the goal 2.5 m above
  // it; the tangent point lies at the angle acos(0.5 / 2.5) before the goal's direction.
  const double rest = 2.5, angle = M_PI - std::acos(kTurningRadius / rest);
  const double expected =
      kTurningRadius * angle + std::sqrt(rest * rest - kTurningRadius * kTurningRadius);
  EXPECT_NEAR(obstacle_free_bound(problem(world, 0, {5, 8}), kTurningRadius, false), expected,
              1e-9);
  EXPECT_NEAR(obstacle_free_bound(problem(world, M_PI, {5, 8}), kTurningRadius, false), expected,
              1e-9)
      << "mirrored";
}

TEST(TurningBound, OfAGoalInATurningCircleIsTwoArcs) {
  // The goal, 0.5 m to the left of the car, is the center of its left circle. The center of the
  // second circle is 1 m from that of the right one, which is 1 m from the goal, and 0.5 m from the
  // goal: the law of cosines gives the angles at both.
  const World world = room();
  const double right = std::acos((1 + 1 - 0.25) / 2);
  const double left = 2 * M_PI - std::acos((1 + 0.25 - 1) / (2 * 0.5));
  EXPECT_NEAR(obstacle_free_bound(problem(world, 0, {5, 5.5}), kTurningRadius, false),
              kTurningRadius * (right + left), 1e-9);
}

/// The least length over all headings of Dubins' six words, computed apart with 8000 headings and
/// refined, for a radius of 0.8 m.
TEST(TurningBound, IsThatOfDubinsCurvesToAnyHeading) {
  const World world = room();
  EXPECT_NEAR(obstacle_free_bound(problem(world, 0, {5.3, 5.25}), 0.8, false), 5.091184837352,
              1e-9);
}

TEST(TurningBound, ACarThatMayReverseTurnsByAtMost90Degrees) {
  const World world = room();
  const auto bound_at = [&](double heading, bool reversible) {
    return obstacle_free_bound(problem(world, heading, {8, 5}), kTurningRadius, reversible);
  };
  EXPECT_NEAR(bound_at(M_PI, true), 3, 1e-12);
  // Forward only it turns by 180 degrees and twice the angle of the offset of the circle's center.
  const double angle = M_PI + 2 * std::atan(kTurningRadius / 3);
  EXPECT_NEAR(bound_at(M_PI, false), 3 + kTurningRadius * angle, 1e-9);
  EXPECT_NEAR(bound_at(1, true), bound_at(1, false), 1e-6);
  EXPECT_NEAR(bound_at(1 + M_PI, true), bound_at(1, false), 1e-6) << "the same backward";
}

TEST(TurningBound, StraightAheadIsTheShortestPathOfTheDisc) {
  const World world = room();
  EXPECT_DOUBLE_EQ(bound(problem(world, 0, {8, 5}), false), 3);
}

/// Walls that leave a way around on both sides.
Primitives walls() {
  Primitives obstacles;
  obstacles.polygons.push_back({{{6, 3.5}, {6.4, 3.5}, {6.4, 6.5}, {6, 6.5}}});
  obstacles.discs = {{{3.2, 5.2}, 0.4}, {{5.2, 7.6}, 0.5}};
  return obstacles;
}

TEST(TurningBound, CountsTheTurnBeforeAPathAroundObstacles) {
  const World world = room(walls());
  const auto facing_away = problem(world, M_PI, {8, 5});
  const double disc = compute_references(facing_away, nullptr, 0.01, 1).shortest->length;
  // The way leaves at about 60 degrees from the line to the goal: 120 degrees of turning cost at
  // most radius * (angle - sin(angle)) more, if the car proceeds along the path meanwhile.
  const double angle = 2 * M_PI / 3;
  const double lower = bound(facing_away, false);
  EXPECT_GT(lower, disc + 0.7 * kTurningRadius * (angle - std::sin(angle)));
  EXPECT_GT(lower, obstacle_free_bound(facing_away, kTurningRadius, false));
  EXPECT_LT(bound(facing_away, true), lower) << "backward the turn is smaller";
}

/// Drives arcs of random curvature; the length until it would collide or 6 m are driven.
double drive_at_random(RandomEngine& engine, const PlanningProblem& problem, bool reversible,
                       mrpt::math::TPoint2D& position) {
  constexpr double kStep = 0.01;  // m
  double heading = problem.start_heading, driven = 0;
  position = problem.start;
  while (driven < 6) {
    const double curvature = uniform_int(engine, -1, 1) / kTurningRadius;
    const double sign = reversible && uniform_int(engine, 0, 3) == 0 ? -1 : 1;
    const double part = uniform_real(engine, 0.1, 1.5);
    for (double along = 0; along < part; along += kStep) {
      const double turned = heading + sign * curvature * kStep;
      const double middle = 0.5 * (heading + turned);  // a chord, shorter than the arc
      const mrpt::math::TPoint2D next(position.x + sign * kStep * std::cos(middle),
                                      position.y + sign * kStep * std::sin(middle));
      if (!is_free(problem.world, {position, next}, problem.robot_radius)) return driven;
      position = next;
      heading = turned;
      driven += kStep;
    }
  }
  return driven;
}

TEST(TurningBound, NoDriveIsShorter) {
  const World world = room(walls());
  RandomEngine engine(3);
  int tight = 0;
  for (int i = 0; i < 60; ++i) {
    const bool reversible = i % 2 == 1;
    PlanningProblem drive = problem(world, uniform_real(engine, -M_PI, M_PI), {5, 5});
    const double driven = drive_at_random(engine, drive, reversible, drive.goal);
    const double lower = bound(drive, reversible);
    // Each chord has the length of the arc: longer than a chord by a fraction of 2e-5.
    EXPECT_LE(lower, driven * (1 + 2e-5)) << i;
    if (lower > 0.95 * driven) ++tight;
  }
  EXPECT_GT(tight, 3) << "no drive is nearly as short as the bound";
}

}  // namespace
}  // namespace slalom
