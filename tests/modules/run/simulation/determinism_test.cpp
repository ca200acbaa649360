// SPDX-License-Identifier: BSD-3-Clause
#include "test_runs.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(Simulate, GivesTheSameTrajectoryForTheSameSeed) {
  RandomEngine random(1);
  const World world = random_cells(random, 0.01);
  RandomMethod method{RobotModel()}, another{RobotModel()};
  const SimulationResult first = run(world, method), second = run(world, another);
  EXPECT_EQ(first.trajectory.hash(), second.trajectory.hash());
  EXPECT_EQ(first.outcome, second.outcome);
  EXPECT_EQ(first.detail, second.detail);
  EXPECT_NE(run(world, method, {}, {}, 2).trajectory.hash(), first.trajectory.hash());
}

TEST(Simulate, GivesThisTrajectoryToTheBit) {
  // Sensing, limits, motion and contact of 100 random commands; a change that alters any of them
  // changes the hash, and has to say so.
  RandomEngine random(1);
  const World world = random_cells(random, 0.01);
  RandomMethod method{RobotModel()};
  EXPECT_EQ(run(world, method).trajectory.hash(), "4ec59820de265203eb389f17e5cc90d2");
}

TEST(Simulate, DoesNotDependOnTheRunsBefore) {
  RandomEngine random(2);
  const World world = random_cells(random, 0.01), other = random_cells(random, 0.03);
  RandomMethod method{RobotModel()};
  const std::string first = run(world, method).trajectory.hash();
  for (std::uint64_t seed = 10; seed < 20; ++seed) {
    run(other, method, {}, {}, seed);
    EXPECT_EQ(run(world, method).trajectory.hash(), first);
  }
}

TEST(Simulate, PassesTheTaskToTheMethod) {
  class TaskRecorder : public RandomMethod {
   public:
    using RandomMethod::RandomMethod;
    void reset(const NavigationTask& task) override {
      received = task;
      RandomMethod::reset(task);
    }
    NavigationTask received;
  };
  const World world = square_world({2, 3, 0.5}, {8, 7});
  SimulationOptions options;
  options.goal_tolerance = 0.3;
  TaskRecorder method{RobotModel()};
  run(world, method, options, {}, 77);
  EXPECT_EQ(method.received.start, world.scenario().start());
  EXPECT_EQ(method.received.goal, world.scenario().goal());
  EXPECT_EQ(method.received.goal_tolerance, 0.3);
  EXPECT_EQ(method.received.control_period, options.control_period);
  EXPECT_EQ(method.received.seed, derive_seed(77, "method"))
      << "its own stream, independent of noise";
}

}  // namespace
}  // namespace slalom::testing
