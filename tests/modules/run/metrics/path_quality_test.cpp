// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <slalom/core/random.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(PathLength, IgnoresTheHeading) {
  Path points;
  for (int i = 0; i <= 600; ++i) points.emplace_back(2 + 0.01 * i, 5);
  MeasuredRun run(points);
  for (std::size_t i = 0; i < run.trajectory.samples.size(); ++i)
    run.trajectory.samples[i].pose.phi = std::remainder(0.7 * static_cast<double>(i), 2 * M_PI);
  EXPECT_NEAR(run.number("path_length"), 6, 1e-12);
}

TEST(PathLength, IsZeroWithoutMotion) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}});
  run.outcome = Outcome::Stuck;
  EXPECT_EQ(run.number("path_length"), 0);
}

TEST(Optimality, IsOneOnTheShortestPath) {
  EXPECT_DOUBLE_EQ(MeasuredRun({{2, 5}, {5, 5}, {8, 5}}).number("optimality"), 1);
}

TEST(Optimality, IncludesTheLastSegmentToTheGoal) {
  // The run ends 0.2 m before the goal: 5.8 m traveled, 6 m including the last segment.
  const MeasuredRun run({{2, 5}, {7.8, 5}});
  EXPECT_DOUBLE_EQ(run.number("path_length"), 5.8);
  EXPECT_DOUBLE_EQ(run.number("optimality"), 1);
  EXPECT_DOUBLE_EQ(run.number("spl"), 1);
}

TEST(Optimality, MeasuresThePathAsDriven) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.trajectory.samples[0].traveled = 1;
  run.trajectory.samples[1].traveled = 9;
  EXPECT_DOUBLE_EQ(run.number("path_length"), 8);
  EXPECT_DOUBLE_EQ(run.number("mean_speed"), 80);
  EXPECT_DOUBLE_EQ(run.number("optimality"), 0.75);
}

TEST(Optimality, ClosesTheRunAroundWhatStandsBeforeTheGoal) {
  // A wall from y = 3 upwards occupies x = 7..7.5; the run ends above its lower end, 1.5 m before
  // the goal at (8, 5). A robot at (6.5, 5) has to go around the corners (7, 3) and (7.5, 3) at
  // 0.25 m: to the first one sqrt(0.5^2 + 2^2 - r^2), and so on.
  const double r = 0.25 - 1e-9;
  Primitives wall;
  wall.polygons.push_back({{{7.01, 3.01}, {7.49, 3.01}, {7.49, 9.99}, {7.01, 9.99}}});
  MeasuredRun run({{2, 5}, {6.5, 5}}, wall);
  const double leg = std::hypot(0.5, 2);
  const double rest =
      2 * (std::sqrt(leg * leg - r * r) + r * (std::atan2(2, 0.5) + std::asin(r / leg))) + 0.5;
  EXPECT_NEAR(run.number("optimality"), 6 / (4.5 + rest), 1e-9);
  EXPECT_NEAR(run.number("path_excess"), (4.5 + rest) / 6 - 1, 1e-9);
  EXPECT_NEAR(run.number("spl"), 6 / (4.5 + rest), 1e-9);
}

TEST(Optimality, IncludesThePathFromTheStartToWhereALogBegins) {
  EXPECT_NEAR(MeasuredRun({{2, 6}, {8, 6}, {8, 5}}).number("optimality"), 6.0 / 8, 1e-12);
}

TEST(Optimality, IsNaForARunThatEndsInsideAnObstacle) {
  Primitives block;
  block.polygons.push_back({{{7, 4.5}, {7.5, 4.5}, {7.5, 5.5}, {7, 5.5}}});
  const MeasuredRun run({{2, 5}, {7.2, 5}}, block);
  for (const std::string id : {"optimality", "path_excess", "spl"})
    EXPECT_EQ(run.reason(id),
              "from the final pose: start is closer to an obstacle than the robot's radius")
        << id;
}

TEST(Optimality, OfALengthBelowTheBoundByRoundingErrorsIsOne) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.references.shortest->exact_length = 6 * (1 + 1e-12);
  EXPECT_EQ(run.number("optimality"), 1);
  EXPECT_EQ(run.number("path_excess"), 0);
}

TEST(Optimality, IsTheRatioToTheShortestLength) {
  // Two sides of sqrt(3^2 + 1^2) m instead of 6 m.
  const MeasuredRun run({{2, 5}, {5, 6}, {8, 5}});
  EXPECT_NEAR(run.number("optimality"), 6 / (2 * std::sqrt(10)), 1e-12);
  EXPECT_NEAR(run.number("spl"), 6 / (2 * std::sqrt(10)), 1e-12);
}

TEST(PathExcess, IsTheRelativeExcessLength) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {5, 6}, {8, 5}}).number("path_excess"),
              2 * std::sqrt(10) / 6 - 1, 1e-12);
  EXPECT_NEAR(MeasuredRun({{2, 5}, {7.8, 5}}).number("path_excess"), 0, 1e-12);
}

TEST(PathExcess, IsNaIfStartAndGoalCoincide) {
  MeasuredRun run({{8, 5}, {8, 5.1}});
  run.set_shortest({{8, 5}});
  EXPECT_EQ(run.reason("path_excess"), "start and goal coincide");
}

TEST(Spl, IsAtMostOneEvenIfTheReferenceIsNotTheShortest) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.set_shortest({{2, 5}, {5, 5.1}, {8, 5}});
  EXPECT_GT(run.number("optimality"), 1);
  EXPECT_EQ(run.number("spl"), 1);
}

TEST(Spl, IsZeroOnFailureAndNaIfNotAttributableToTheMethod) {
  MeasuredRun run({{2, 5}, {3, 5}});
  for (const Outcome outcome : enum_values<Outcome>()) {
    run.outcome = outcome;
    if (outcome == Outcome::UnsolvableScenario || outcome == Outcome::InfrastructureError) {
      EXPECT_EQ(run.reason("spl"), "outcome: " + to_string(outcome));
    } else if (outcome != Outcome::Success) {
      EXPECT_EQ(run.number("spl"), 0) << to_string(outcome);
    }
  }
}

TEST(OptimalityArea, IsTheAreaBetweenBothPathsPerLength) {
  // On a triangle of height 1 m over 6 m the distance increases linearly to 1 m and decreases
  // again: its mean is 0.5 m, over 2 sqrt(10) m traveled; divided by 6 m.
  EXPECT_NEAR(MeasuredRun({{2, 5}, {5, 6}, {8, 5}}).number("optimality_area"), std::sqrt(10) / 6,
              1e-3);
  // The goal tolerance has no effect on the path itself.
  EXPECT_NEAR(MeasuredRun({{2, 5}, {7.8, 5}}).number("optimality_area"), 0, 1e-12);
}

TEST(OptimalityArea, MeasuresTheDistanceToTheEndPointsBeyondThePath) {
  // Back from 2 to 1 m, on to 9 m and back to 8 m: of the 10 m traveled four lie up to 1 m beyond
  // the ends, 0.5 m on average, the others on the path.
  EXPECT_NEAR(MeasuredRun({{2, 5}, {1, 5}, {9, 5}, {8, 5}}).number("optimality_area"), 2.0 / 6,
              1e-9);
}

/// The same integral by brute force over all segments of the path.
double plain_area(const Path& traveled, const Path& reference) {
  const Path points = resample(traveled, 0.02);
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += 0.5 * length({points[i - 1], points[i]}) *
           (distance_to_path(points[i - 1], reference) + distance_to_path(points[i], reference));
  return sum;
}

TEST(OptimalityArea, AgreesWithBruteForceOnPathsOfManySegments) {
  RandomEngine random(6);
  const auto random_path = [&](int segments) {
    Path path;
    for (int i = 0; i <= segments; ++i)
      path.emplace_back(uniform_real(random, 1, 9), uniform_real(random, 1, 9));
    return path;
  };
  for (int i = 0; i < 30; ++i) {
    const Path traveled = random_path(uniform_int(random, 1, 8));
    const Path best =
        resample(random_path(uniform_int(random, 1, 12)), uniform_real(random, 0.05, 1));
    MeasuredRun run(traveled);
    run.set_shortest(best);
    run.set_safest(best);
    const double expected = plain_area(traveled, best) / length(best);
    EXPECT_NEAR(run.number("optimality_area"), expected, 1e-12 * (1 + expected));
    EXPECT_NEAR(run.number("safety_area"), expected, 1e-12 * (1 + expected));
  }
}

}  // namespace
}  // namespace slalom::testing
