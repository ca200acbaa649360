// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <slalom/simulation/evaluate_trajectory.h>

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// One sample each second at these points.
Trajectory log_of(const Path& points) {
  Trajectory log;
  for (const auto& p : points) {
    Sample sample;
    sample.t = 100 + static_cast<double>(log.samples.size());
    sample.pose = {p.x, p.y, 0};
    sample.v = static_cast<double>(log.samples.size());
    log.samples.push_back(sample);
  }
  return log;
}

SimulationResult evaluate(const World& world, const Path& points,
                          const SimulationOptions& options = {}, const RobotModel& robot = {}) {
  return evaluate_trajectory(world, robot, options, log_of(points));
}

TEST(EvaluateTrajectory, EndsWhereTheGoalIsReached) {
  const SimulationResult result =
      evaluate(square_world({2, 5, 0}, {8, 5}), {{2, 5}, {5, 5}, {8, 5}, {9, 5}});
  EXPECT_EQ(result.outcome, Outcome::Success);
  // Within 0.2 m of the goal at x = 7.8, 2.8 m of the 3 m after the second sample.
  const Sample& last = result.trajectory.samples.back();
  EXPECT_EQ(result.trajectory.samples.size(), 3U);
  EXPECT_NEAR(last.pose.x, 7.8, 0.011);
  EXPECT_NEAR(last.t, 101 + 2.8 / 3, 0.004);
  EXPECT_NEAR(last.v, 1 + 2.8 / 3, 0.004);
}

TEST(EvaluateTrajectory, ATimeoutInAGapIsAtTheTimeLimit) {
  SimulationOptions options;
  options.max_time = 60;
  for (const double driven : {0.0, 1.0}) {
    Trajectory log = log_of({{2, 5}, {2 + driven, 5}});
    log.samples[1].t = log.samples[0].t + 100;
    const SimulationResult result =
        evaluate_trajectory(square_world({2, 5, 0}, {8, 5}), {}, options, log);
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_NEAR(result.trajectory.duration(), 60, 1e-9);
    EXPECT_NEAR(result.trajectory.samples.back().pose.x, 2 + 0.6 * driven, 1e-9);
  }
}

TEST(EvaluateTrajectory, EndsAtAContactBetweenSamples) {
  // A column whose cells begin at x = 5, between two samples that are both free.
  const Primitives column{{}, {Polygon{{{5.01, 4.51}, {5.49, 4.51}, {5.49, 5.49}, {5.01, 5.49}}}}};
  const SimulationResult result =
      evaluate(square_world({2, 5, 0}, {8, 5}, column), {{2, 5}, {8, 5}});
  EXPECT_EQ(result.outcome, Outcome::Collision);
  EXPECT_NEAR(result.trajectory.samples.back().pose.x, 5 - 0.25, 1e-6);
  EXPECT_NE(result.detail.find("contact at (4.75, 5.00) m after 0.46 s"), std::string::npos)
      << result.detail;
}

TEST(EvaluateTrajectory, ChecksAPolygonDuringRotation) {
  // 0.8 m long, next to a wall 0.3 m away: free along it, in contact if rotated by 90 degrees.
  RobotModel robot;
  robot.footprint = "0.4,0.2; -0.4,0.2; -0.4,-0.2; 0.4,-0.2";
  Trajectory log = log_of({{2, 0.3}, {3, 0.3}, {3, 0.3}});
  log.samples[2].pose.phi = M_PI / 2;
  const World world = square_world({2, 0.3, 0}, {8, 5});
  const SimulationResult result = evaluate_trajectory(world, robot, {}, log);
  EXPECT_EQ(result.outcome, Outcome::Collision);
  // 0.4 sin phi + 0.2 cos phi = 0.3
  const double phi = result.trajectory.samples.back().pose.phi;
  EXPECT_NEAR(0.4 * std::sin(phi) + 0.2 * std::cos(phi), 0.3, 1e-3);
  log.samples.pop_back();
  EXPECT_EQ(evaluate_trajectory(world, robot, {}, log).outcome, Outcome::Timeout);
}

TEST(EvaluateTrajectory, EndsWhenTheTimeIsOver) {
  SimulationOptions options;
  options.max_time = 1.5;
  const SimulationResult result =
      evaluate(square_world({2, 5, 0}, {8, 5}), {{2, 5}, {3, 5}, {4, 5}, {8, 5}}, options);
  EXPECT_EQ(result.outcome, Outcome::Timeout);
  EXPECT_NEAR(result.trajectory.duration(), 1.5, 0.011);
}

TEST(EvaluateTrajectory, EndsWhereTheRobotIsStuck) {
  SimulationOptions options;
  options.stuck_time = 6;
  Path log(10, {3, 5});
  log.front() = {2, 5};
  log.back() = {8, 5};
  const SimulationResult result = evaluate(square_world({2, 5, 0}, {8, 5}), log, options);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_EQ(result.trajectory.duration(), 7);
}

TEST(EvaluateTrajectory, CountsALogThatEndsTooEarlyAsTimeout) {
  const SimulationResult result = evaluate(square_world({2, 5, 0}, {8, 5}), {{2, 5}, {3, 5}});
  EXPECT_EQ(result.outcome, Outcome::Timeout);
  EXPECT_EQ(result.detail, "the log ends 5.00 m before the goal at (3.00, 5.00) m after 1.00 s");
}

TEST(EvaluateTrajectory, OfALogThatEndsWithAnotherHeadingSaysWhatIsLeft) {
  const World world(square_world({2, 5, 0}, {8, 5}).scenario().with_goal_heading(-1.5), 0.05);
  const SimulationResult result = evaluate(world, {{2, 5}, {8, 5}});
  EXPECT_EQ(result.outcome, Outcome::Timeout);
  EXPECT_EQ(result.detail.find("the log ends 0.00 m and 1.50 rad before the goal"), 0U)
      << result.detail;
}

TEST(EvaluateTrajectory, RobotThatNeverMovesDoesNotSucceed) {
  EXPECT_EQ(evaluate(square_world({2, 5, 0}, {8, 5}), {{2, 5}, {2, 5}}).outcome, Outcome::Timeout);
}

TEST(EvaluateTrajectory, ALogThatBeginsOutsideOfTheWorkspaceSaysSo) {
  const SimulationResult result = evaluate(square_world({2, 5, 0}, {8, 5}), {{-3, 5}, {8, 5}});
  EXPECT_EQ(result.outcome, Outcome::UnsolvableScenario);
  EXPECT_EQ(result.detail,
            "the log begins outside of the workspace at (-3.00, 5.00) m after 0.00 s");
}

TEST(EvaluateTrajectory, LogThatBeginsInContactIsUnsolvable) {
  const SimulationResult result = evaluate(square_world({2, 5, 0}, {8, 5}), {{0.1, 5}, {8, 5}});
  EXPECT_EQ(result.outcome, Outcome::UnsolvableScenario);
  EXPECT_EQ(result.trajectory.samples.size(), 1U);
}

TEST(EvaluateTrajectory, AgreesWithTheSimulator) {
  RandomEngine random(9);
  const RobotModel robot;
  SimulationOptions options;
  options.control_period = options.step;  // so that the log has every simulated step
  int collisions = 0;
  for (int i = 0; i < 20; ++i) {
    const World world = random_cells(random, 0.02);
    RandomMethod method(robot);
    const SimulationResult run = simulate(world, {robot, {}, {}, options, {}}, i + 1, method);
    const SimulationResult again = evaluate_trajectory(world, robot, options, run.trajectory);
    EXPECT_EQ(again.outcome, run.outcome) << run.detail << "; " << again.detail;
    EXPECT_NEAR(again.trajectory.duration(), run.trajectory.duration(), 1e-6);
    if (run.outcome == Outcome::Collision) ++collisions;
  }
  EXPECT_GT(collisions, 5);
}

}  // namespace
}  // namespace slalom::testing
