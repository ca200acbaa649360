// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slalom::testing {
namespace {

TEST(Simulate, ReachesAGoalAheadWithATrapezoidalVelocityProfile) {
  const World world = square_world({1, 5, 0}, {8, 5});
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  EXPECT_EQ(result.outcome, Outcome::Success);
  // 7 m less the tolerance of 0.2 m: 0.5 m in 1 s while it accelerates to 1 m/s, the rest at 1 m/s.
  EXPECT_NEAR(result.trajectory.duration(), 1 + (7 - 0.2 - 0.5), 0.01 + 1e-9);
  EXPECT_NEAR(result.trajectory.samples.back().pose.x, 7.8, 0.01 + 1e-9);
  EXPECT_NEAR(result.trajectory.samples.back().pose.y, 5, 1e-12);
}

TEST(Simulate, AGoalWithAHeadingIsReachedWithinItsTolerance) {
  // The robot turns to the left at its start, which is the goal, at 1 rad/s from the second step
  // on.
  RobotModel agile;
  agile.max_accel_v = agile.max_accel_w = 1e6;
  SimulationOptions options;
  options.goal_heading_tolerance = 0.3;
  const auto turned = [&](double heading, double w) {
    const World world(square_world({5, 5, 3}, {5, 5}).scenario().with_goal_heading(heading), 0.05);
    FunctionMethod turn = constant_method(0, w);
    return run(world, turn, options, agile);
  };
  EXPECT_EQ(turned(3.2, 0).trajectory.duration(), 0);
  for (const double heading : {4.5, 4.5 - 2 * M_PI}) {
    const SimulationResult result = turned(heading, 1);
    EXPECT_EQ(result.outcome, Outcome::Success);
    EXPECT_NEAR(result.trajectory.duration(), 1.5 - 0.3, 0.02);
  }
  EXPECT_EQ(turned(4.5, 0).outcome, Outcome::Stuck);
}

TEST(Simulate, RecordsOneSamplePerControlCycleAndTheFinalOne) {
  const World world = square_world({1, 5, 0}, {8, 5});
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  const auto& samples = result.trajectory.samples;
  ASSERT_EQ(samples.size(), result.cycle_seconds.size() + 1);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    EXPECT_DOUBLE_EQ(samples[i].t, 0.1 * static_cast<double>(i));
    EXPECT_EQ(samples[i].command_v, 1);
  }
  EXPECT_GT(samples.back().t, samples[samples.size() - 2].t);
}

TEST(Simulate, RecordsTheDistanceDrivenAlongArcs) {
  // A circle of 0.5 m at 0.5 m/s for 3 s, less half of the step in which it accelerates.
  RobotModel agile;
  agile.max_accel_v = agile.max_accel_w = 1e6;
  SimulationOptions options;
  options.max_time = 3;
  FunctionMethod circle = constant_method(0.5, 1);
  const Trajectory driven = run(square_world({5, 5, 0}, {9, 9}), circle, options, agile).trajectory;
  EXPECT_EQ(driven.samples.front().traveled, 0);
  EXPECT_NEAR(driven.samples.back().traveled, 0.5 * (3 - 0.005), 1e-9);
  EXPECT_LT(length(driven.path()), driven.traveled() - 1e-4) << "chords between control cycles";
}

TEST(Simulate, RecordsTheDistanceDrivenUpToTheContact) {
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(square_world({5, 5, 0}, {5, 9}), forward);
  EXPECT_EQ(result.outcome, Outcome::Collision);
  EXPECT_NEAR(result.trajectory.traveled(), 10 - 0.25 - 5, 1e-8);
}

TEST(Simulate, KeepsVelocitiesAndAccelerationsWithinTheLimits) {
  const World world = square_world({5, 5, 0}, {9.9, 9.9});
  const RobotModel robot;
  RandomMethod method(robot);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto samples = run(world, method, {}, robot, seed).trajectory.samples;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double dt = samples[i].t - samples[i - 1].t;
      EXPECT_LE(samples[i].v, robot.max_v);
      EXPECT_GE(samples[i].v, 0);
      EXPECT_LE(std::abs(samples[i].w), robot.max_w);
      // Velocities are those at the end of a motion step, which a contact may cut short.
      EXPECT_LE(std::abs(samples[i].v - samples[i - 1].v), robot.max_accel_v * (dt + 0.01));
      EXPECT_LE(std::abs(samples[i].w - samples[i - 1].w), robot.max_accel_w * (dt + 0.01));
    }
  }
}

TEST(Simulate, SucceedsImmediatelyIfTheStartIsAtTheGoal) {
  const World world = square_world({5, 5, 0}, {5.1, 5});
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  EXPECT_EQ(result.outcome, Outcome::Success);
  EXPECT_EQ(result.trajectory.samples.size(), 1U);
  EXPECT_TRUE(result.cycle_seconds.empty());
}

TEST(Simulate, CallsAStartOnAnObstacleUnsolvable) {
  Primitives obstacles;
  obstacles.discs.push_back({{1.3, 5}, 0.2});
  const World world = square_world({1, 5, 0}, {8, 5}, obstacles);
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  EXPECT_EQ(result.outcome, Outcome::UnsolvableScenario);
  EXPECT_EQ(result.trajectory.samples.size(), 1U);
  EXPECT_NE(result.detail, "");
}

TEST(Simulate, CollidesWithTheBorder) {
  const World world = square_world({5, 5, 0}, {1, 1});
  FunctionMethod forward = constant_method(1, 0);
  const SimulationResult result = run(world, forward);
  EXPECT_EQ(result.outcome, Outcome::Collision);
  EXPECT_NEAR(result.trajectory.samples.back().pose.x, 10 - 0.25, 1e-8);
}

TEST(Simulate, TimesOutExactlyAtTheMaximumTime) {
  const World world = square_world({5, 5, 0}, {1, 1});
  FunctionMethod circle = constant_method(0.5, 0.5);
  for (const double max_time : {5.0, 5.03, 4.96}) {
    SimulationOptions options;
    options.max_time = max_time;
    const SimulationResult result = run(world, circle, options);
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_NEAR(result.trajectory.duration(), max_time, 1e-9);
  }
}

TEST(Simulate, NeverSucceedsAfterTheMaximumTime) {
  const World world = square_world({1, 5, 0}, {7.95, 5});  // reached after 7.25 s
  FunctionMethod forward = constant_method(1, 0);
  SimulationOptions options;
  options.max_time = 7.22;
  EXPECT_EQ(run(world, forward, options).outcome, Outcome::Timeout);
  options.max_time = 7.28;
  EXPECT_EQ(run(world, forward, options).outcome, Outcome::Success);
}

TEST(Simulate, CallsStoppedAndRotatingRobotsStuck) {
  const World world = square_world({5, 5, 0}, {1, 1});
  SimulationOptions options;
  for (const double w : {0.0, 1.0}) {
    FunctionMethod method = constant_method(0, w);
    const SimulationResult result = run(world, method, options);
    EXPECT_EQ(result.outcome, Outcome::Stuck);
    EXPECT_NEAR(result.trajectory.duration(), options.stuck_time, 1e-9);
  }
}

TEST(Simulate, ARobotThatDoesWhatItCanIsNotStuck) {
  // A half turn at 0.35 rad/s takes 9 s, 0.5 m at 0.13 m/s 4 s.
  SimulationOptions options;
  options.max_time = 60;
  RobotModel slow;
  slow.max_w = 0.35;
  slow.max_v = 0.13;
  options.stuck_distance = 0.5;
  for (const double stuck_time : {1.0, 8.0}) {
    options.stuck_time = stuck_time;
    FunctionMethod turns([&slow](const Observation& o) {
      const double bearing = std::atan2(o.goal_in_robot.y, o.goal_in_robot.x);
      const double w = std::clamp(bearing, -slow.max_w, slow.max_w);
      return Command{std::abs(bearing) > 0.1 ? 0 : slow.max_v, w};
    });
    EXPECT_EQ(run(square_world({5, 5, 0}, {2, 5}), turns, options, slow).outcome, Outcome::Success);
  }
  EXPECT_NEAR(options.stuck_limit(slow), 1.5 * (M_PI / 0.35 + 0.35 / 3 + 0.5 / 0.13 + 0.13), 1e-9);
  EXPECT_EQ(SimulationOptions().stuck_limit(RobotModel()), 8);
}

TEST(Simulate, CallsCreepingStuckButNotSlowProgress) {
  const World world = square_world({2, 5, 0}, {1, 1});
  SimulationOptions options;
  options.max_time = 20;
  // 8 s at 0.01 m/s are 0.08 m, less than 0.1 m; at 0.02 m/s they are 0.16 m.
  FunctionMethod creeping = constant_method(0.01, 0), slow = constant_method(0.02, 0);
  EXPECT_EQ(run(world, creeping, options).outcome, Outcome::Stuck);
  EXPECT_EQ(run(world, slow, options).outcome, Outcome::Timeout);
}

TEST(Simulate, CountsStuckTimeFromWhereTheRobotStops) {
  const World world = square_world({2, 5, 0}, {1, 1});
  FunctionMethod method([](const Observation& o) { return Command{o.time < 3.95 ? 0.5 : 0.0, 0}; });
  const SimulationResult result = run(world, method);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  // It stops at 4.0 + 0.5 s and came within 0.1 m of that position when 0.5^2 / 2 > 0.1, i.e.
  // braking at v = sqrt(2 * 0.1) = 0.447, 0.053 s after 4 s; samples come every 0.1 s: 4.1 + 8 s.
  EXPECT_NEAR(result.trajectory.duration(), 12.1, 1e-9);
}

TEST(Simulate, EndsARunOnAnInvalidCommand) {
  const World world = square_world({1, 5, 0}, {8, 5});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Command bad :
       {Command{nan, 0}, Command{0, -HUGE_VAL}, Command{1.5, 0}, Command{0, 2}, Command{-0.1, 0}}) {
    FunctionMethod method([&](const Observation& o) {
      return o.time < 0.95 ? Command{1, 0} : bad;
    });
    const SimulationResult result = run(world, method);
    EXPECT_EQ(result.outcome, Outcome::MethodInvalidCommand);
    EXPECT_NEAR(result.trajectory.duration(), 1.0, 1e-12);
    EXPECT_NE(result.detail.find("after 1.00 s"), std::string::npos) << result.detail;
    for (const Sample& sample : result.trajectory.samples) EXPECT_EQ(sample.command_v, 1);
  }
}

TEST(Simulate, EndsARunOnAnyExceptionOfTheMethod) {
  const World world = square_world({1, 5, 0}, {8, 5});
  FunctionMethod throws_error([](const Observation& o) -> Command {
    if (o.time > 0.45) throw std::runtime_error("no path");
    return {1, 0};
  });
  const SimulationResult result = run(world, throws_error);
  EXPECT_EQ(result.outcome, Outcome::MethodError);
  EXPECT_EQ(result.detail, "no path, at (1.13, 5.00) m after 0.50 s");
  EXPECT_NEAR(result.trajectory.duration(), 0.5, 1e-12);
  FunctionMethod throws_int([](const Observation&) -> Command { throw 42; });
  EXPECT_EQ(run(world, throws_int).outcome, Outcome::MethodError);
  EXPECT_NE(run(world, throws_int).detail, "");
}

class ThrowsInReset : public Method {
 public:
  void reset(const NavigationTask&) override { throw MethodError("out of memory"); }
  Command step(const Observation&) override { return {}; }
};

TEST(Simulate, EndsARunWhenTheMethodCannotBeReset) {
  ThrowsInReset method;
  const SimulationResult result = run(square_world({1, 5, 0}, {8, 5}), method);
  EXPECT_EQ(result.outcome, Outcome::MethodError);
  EXPECT_EQ(result.detail, "out of memory, at (1.00, 5.00) m after 0.00 s");
  EXPECT_EQ(result.trajectory.samples.size(), 1U);
}

/// Waits long until it is ready, by the clock of the run.
class SlowStarter : public Method {
 public:
  SlowStarter(double& time, bool paced) : time_(time), paced_(paced) {}
  void reset(const NavigationTask&) override { calls += "reset "; }
  void settle(const Observation& start) override {
    calls += "settle ";
    start_ = start.odometry;
    time_ += 100;
  }
  Command step(const Observation& observation) override {
    if (observation.time == 0) {
      calls += "step";
      EXPECT_EQ(observation.odometry, start_);
    }
    time_ += 0.01;
    return {1, 0};
  }
  bool is_paced() const override { return paced_; }
  std::string calls;

 private:
  double& time_;
  bool paced_;
  mrpt::math::TPose2D start_;
};

TEST(Simulate, TheTimeUntilAMethodIsReadyIsNotThatOfACycle) {
  double time = 0;
  RunSetup setup;
  setup.clock = [&] { return time; };
  setup.deadline.cycle_deadline = 0.5;
  const World world = square_world({1, 5, 0}, {8, 5});
  for (const bool paced : {false, true}) {
    SlowStarter method(time, paced);
    const SimulationResult result = simulate(world, setup, 1, method);
    EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
    EXPECT_EQ(method.calls, "reset settle step");
    if (paced)
      EXPECT_TRUE(result.cycle_seconds.empty()) << "its computing time is not known";
    else
      EXPECT_NEAR(result.cycle_seconds.front(), 0.01, 1e-9);
  }
}

class ThrowsInSettle : public ThrowsInReset {
 public:
  void reset(const NavigationTask&) override {}
  void settle(const Observation&) override { throw MethodTimeout("no node"); }
};

TEST(Simulate, EndsARunWhenTheMethodIsNotReady) {
  ThrowsInSettle method;
  const SimulationResult result = run(square_world({1, 5, 0}, {8, 5}), method);
  EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
  EXPECT_EQ(result.detail, "no node, at (1.00, 5.00) m after 0.00 s");
}

TEST(Simulate, EndsARunAsMethodDeadlineOnAMethodTimeout) {
  FunctionMethod waits([](const Observation& o) -> Command {
    if (o.time > 0.45) throw MethodTimeout("no response");
    return {1, 0};
  });
  const SimulationResult result = run(square_world({1, 5, 0}, {8, 5}), waits);
  EXPECT_EQ(result.outcome, Outcome::MethodDeadline);
  EXPECT_EQ(result.detail.rfind("no response, at (", 0), 0U) << result.detail;
  EXPECT_NEAR(result.trajectory.duration(), 0.5, 1e-12);
}

/// Records the outcome, and throws.
class OutcomeRecorder : public FunctionMethod {
 public:
  using FunctionMethod::FunctionMethod;
  void finish(const std::string& outcome) override {
    outcomes.push_back(outcome);
    throw MethodError("refused");
  }
  std::vector<std::string> outcomes;
};

TEST(Simulate, NotifiesTheMethodOnceOfTheOutcome) {
  OutcomeRecorder succeeds([](const Observation&) { return Command{1, 0}; });
  EXPECT_EQ(run(square_world({1, 5, 0}, {8, 5}), succeeds).outcome, Outcome::Success);
  OutcomeRecorder fails([](const Observation&) -> Command { throw MethodError("no"); });
  EXPECT_EQ(run(square_world({1, 5, 0}, {8, 5}), fails).outcome, Outcome::MethodError);
  EXPECT_EQ(succeeds.outcomes, std::vector<std::string>{"success"});
  EXPECT_EQ(fails.outcomes, std::vector<std::string>{"method_error"});
  Primitives obstacles;
  obstacles.discs.push_back({{1, 5}, 0.5});
  OutcomeRecorder never_started([](const Observation&) { return Command{}; });
  EXPECT_EQ(run(square_world({1, 5, 0}, {8, 5}, obstacles), never_started).outcome,
            Outcome::UnsolvableScenario);
  EXPECT_TRUE(never_started.outcomes.empty());
}

/// Keeps the map that it is given, if it declares that it uses it.
class MapUser : public Method {
 public:
  explicit MapUser(bool declares) : declares_(declares) {}
  void reset(const NavigationTask& task) override {
    if (task.map == nullptr) return;
    map = *task.map;
    cells = *task.map->cells;
  }
  Command step(const Observation&) override { return {}; }
  bool uses_map() const override { return declares_; }
  KnownMap map;
  std::vector<std::uint8_t> cells;

 private:
  bool declares_;
};

TEST(Simulate, GivesTheMapToMethodsThatDeclareThatTheyUseIt) {
  Primitives obstacles;
  obstacles.discs.push_back({{6, 2}, 0.5});
  const World world = square_world({1, 5, 0}, {8, 5}, obstacles);
  SimulationOptions options;
  options.max_time = 1;
  MapUser with(true), without(false);
  run(world, with, options);
  run(world, without, options);
  EXPECT_TRUE(without.cells.empty());
  EXPECT_EQ(with.map.resolution, 0.05);
  EXPECT_EQ(with.map.size_x, 200U);
  EXPECT_EQ(with.cells, world.occupancy().cells());
}

TEST(Simulate, RefusesAStepLongerThanTheControlPeriod) {
  FunctionMethod forward = constant_method(1, 0);
  SimulationOptions options;
  options.step = 1;
  EXPECT_THROW(run(square_world({1, 5, 0}, {8, 5}), forward, options), std::invalid_argument);
  options.step = 0;
  EXPECT_THROW(run(square_world({1, 5, 0}, {8, 5}), forward, options), std::invalid_argument);
}

}  // namespace
}  // namespace slalom::testing
