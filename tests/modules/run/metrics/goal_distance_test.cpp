// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(GoalDistances, AreThoseOfTheLastAndTheNearestSample) {
  const MeasuredRun run({{2, 5}, {8, 6}, {4, 2}});
  EXPECT_DOUBLE_EQ(run.number("final_distance"), 5);
  EXPECT_DOUBLE_EQ(run.number("closest_distance"), 1);
}

TEST(GoalHeadingError, IsTheSmallerAngleBetweenTheHeadings) {
  const auto run_to = [](const mrpt::math::TPoint2D& end, double phi, std::optional<double> goal) {
    MeasuredRun run({{2, 5}, end});
    run.trajectory.samples.back().pose.phi = phi;
    const World world(run.world.scenario().with_goal_heading(goal), 0.05);
    return metric("goal_heading_error")
        .compute(make_metric_context(world, run.robot, run.trajectory, run.outcome, run.references,
                                     60, 0.2));
  };
  EXPECT_NEAR(run_to({8, 5.1}, 0.5, 0.2).number(), 0.3, 1e-12);
  EXPECT_NEAR(run_to({8, 5.1}, 3, -3).number(), 2 * M_PI - 6, 1e-12);
  EXPECT_EQ(run_to({8, 5.1}, M_PI, 0).number(), M_PI);
  EXPECT_EQ(run_to({8, 5.1}, 0, std::nullopt).reason(), "the goal has no heading");
  EXPECT_EQ(run_to({8, 5.3}, 0, 0).reason(), "the run does not end at the goal");
}

TEST(Progress, IsTheCompletedFractionOfThePath) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {5, 5}}).number("progress"), 0.5, 1e-12);
  EXPECT_NEAR(MeasuredRun({{2, 5}, {8, 5}}).number("progress"), 1, 1e-12);
  EXPECT_NEAR(MeasuredRun({{2, 5}}).number("progress"), 0, 1e-12);
  EXPECT_NEAR(MeasuredRun({{2, 5}, {-1, 5}}).number("progress"), -0.5, 1e-12);
}

/// A wall across y = 3..10, so that the path passes below it; it occupies the cells of x = 5..5.5.
Primitives wall() {
  return {{}, {Polygon{{{5.01, 3.01}, {5.49, 3.01}, {5.49, 9.99}, {5.01, 9.99}}}}};
}

TEST(Progress, MeasuresTheRemainingPathAroundObstacles) {
  // From (4, 5) around the corners (5, 3) and (5.5, 3) at 0.25 m. The straight line would be 4 m.
  MeasuredRun run({{2, 5}, {4, 5}}, wall());
  run.outcome = Outcome::Stuck;
  const double rest = 6 * (1 - run.number("progress"));
  // Lower bound: through the corners; upper bound: via points 0.25 m below and next to them.
  EXPECT_GT(rest, std::hypot(1, 2) + 0.5 + std::hypot(2.5, 2));
  EXPECT_LT(rest, 1.01 * (std::hypot(0.75, 2.25) + 1 + std::hypot(2.25, 2.25)));
}

TEST(Progress, IsDefinedForARunThatEndsInContact) {
  MeasuredRun run({{2, 5}, {4.75 + 1e-7, 6}}, wall());
  run.outcome = Outcome::Collision;
  const double rest = 6 * (1 - run.number("progress"));
  EXPECT_GT(rest, 3 + 0.5 + std::hypot(2.5, 2));
  EXPECT_LT(rest, 1.01 * (3.25 + 1.0 + std::hypot(2.25, 2.25)));
}

TEST(Progress, IsNaForARunThatEndsInsideAnObstacle) {
  MeasuredRun run({{2, 5}, {4.9, 6}}, wall());
  run.outcome = Outcome::Collision;
  EXPECT_EQ(run.reason("progress"), "the run ends inside an obstacle");
}

}  // namespace
}  // namespace slalom::testing
