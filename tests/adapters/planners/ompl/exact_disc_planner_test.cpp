// SPDX-License-Identifier: BSD-3-Clause
#include "ompl_worlds.h"

#include <slalom/ompl/exact_disc_planner.h>
#include <slalom/references/disc_path.h>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace slalom {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using mrpt::math::TPoint2D;

ob::ScopedState<> state_at(const ob::StateSpacePtr& space, const TPoint2D& p, double heading = 0) {
  ob::ScopedState<> state(space);
  state[0] = p.x;
  state[1] = p.y;
  if (space->getDimension() == 3) state[2] = heading;
  return state;
}

/// From the world's start to its goal.
og::SimpleSetup exact_setup(const World& world) {
  ompl::msg::noOutputHandler();
  og::SimpleSetup setup(make_disc_space(world, kRadius));
  const PlanningProblem problem = problem_of(world);
  setup.setStartAndGoalStates(state_at(setup.getStateSpace(), problem.start),
                              state_at(setup.getStateSpace(), problem.goal));
  setup.setPlanner(std::make_shared<ExactDiscPlanner>(setup.getSpaceInformation()));
  return setup;
}

double shortest_length(const World& world) {
  std::string reason;
  const PlanningProblem problem = problem_of(world);
  return shortest_disc_path(world.occupancy(), kRadius, problem.start, problem.goal, reason)
      ->length;
}

TEST(ExactDiscPlanner, SolvesASimpleSetupWithTheShortestPath) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  ASSERT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(setup.haveExactSolutionPath());
  EXPECT_EQ(setup.getSolutionPlannerName(), "ExactDiscPlanner");
  og::PathGeometric& path = setup.getSolutionPath();
  EXPECT_TRUE(path.check()) << "not valid for the checks of states and motions";
  const double optimum = shortest_length(world);
  EXPECT_GE(path.length(), optimum * (1 - 1e-12));
  EXPECT_LE(path.length(), optimum * (1 + 1e-6));
  const double straight = std::hypot(6.8, 6.8);
  EXPECT_GT(optimum, straight * 1.001) << "nothing is in the way";
}

/// The length of a planner's path after some iterations, whatever the clock says; infinite without
/// one.
double length_after(int iterations, const ob::PlannerPtr& planner, og::SimpleSetup& setup) {
  setup.clear();
  setup.setPlanner(planner);
  ob::IterationTerminationCondition stop(iterations);
  setup.solve(ob::PlannerTerminationCondition(stop));
  return setup.haveExactSolutionPath() ? setup.getSolutionPath().length()
                                       : std::numeric_limits<double>::infinity();
}

TEST(ExactDiscPlanner, NoPlannerOfOmplFindsAShorterPath) {
  const World world = disc_world();
  const double optimum = shortest_length(world);
  og::SimpleSetup setup = exact_setup(world);
  const ob::SpaceInformationPtr& space = setup.getSpaceInformation();
  const double rrt = length_after(5000, std::make_shared<og::RRTstar>(space), setup);
  const double bit = length_after(5000, std::make_shared<og::BITstar>(space), setup);
  const double exact = length_after(1, std::make_shared<ExactDiscPlanner>(space), setup);
  EXPECT_LE(exact, optimum * (1 + 1e-6));
  EXPECT_LE(exact, std::min(rrt, bit) * (1 + 1e-6));
  EXPECT_LE(std::min(rrt, bit), optimum * 1.05) << "no planner comes near";
}

TEST(ExactDiscPlanner, RunsInTheBenchmarkOfOmpl) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  ompl::tools::Benchmark benchmark(setup, "discs");
  benchmark.addPlanner(std::make_shared<ExactDiscPlanner>(setup.getSpaceInformation()));
  ompl::tools::Benchmark::Request request(60, 1000, 2);
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  request.simplify = false;
  benchmark.benchmark(request);
  const auto& planners = benchmark.getRecordedExperimentData().planners;
  ASSERT_EQ(planners.size(), 1U);
  ASSERT_EQ(planners[0].runs.size(), 2U);
  for (const auto& run : planners[0].runs) {
    EXPECT_EQ(run.at("correct solution BOOLEAN"), "1");
    EXPECT_LE(std::stod(run.at("solution length REAL")), shortest_length(world) * (1 + 1e-6));
  }
  std::ostringstream log;
  ASSERT_TRUE(benchmark.saveResultsToStream(log));
  EXPECT_NE(log.str().find("Experiment discs"), std::string::npos);
  EXPECT_NE(log.str().find("ExactDiscPlanner"), std::string::npos);
}

TEST(ExactDiscPlanner, ProvesThatThereIsNoPath) {
  const World world = divided_world();
  og::SimpleSetup setup = exact_setup(world);
  EXPECT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::ABORT);
  EXPECT_FALSE(setup.haveSolutionPath());
}

TEST(ExactDiscPlanner, TurnsItsHeadingEvenlyInSe2) {
  const World world = disc_world();
  auto poses = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0);
  bounds.setHigh(8);
  poses->setBounds(bounds);
  og::SimpleSetup setup(poses);
  set_disc_checks(setup.getSpaceInformation(), world, kRadius);
  const PlanningProblem problem = problem_of(world);
  setup.setStartAndGoalStates(state_at(poses, problem.start, -1),
                              state_at(poses, problem.goal, 0.5));
  setup.setPlanner(std::make_shared<ExactDiscPlanner>(setup.getSpaceInformation()));
  ASSERT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  // The length in SE(2) is that of the positions and half the rotation: no pose can do with less.
  const double optimum = shortest_length(world) + 0.5 * 1.5;
  EXPECT_TRUE(setup.getSolutionPath().check());
  EXPECT_NEAR(setup.getSolutionPath().length(), optimum, 1e-6 * optimum);
}

TEST(ExactDiscPlanner, ReachesTheNearestOfSeveralGoals) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  const auto goals = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
  goals->addState(state_at(setup.getStateSpace(), {7.4, 7.4}));
  goals->addState(state_at(setup.getStateSpace(), {4.2, 4.4}));  // in an obstacle
  goals->addState(state_at(setup.getStateSpace(), {0.6, 3.6}));
  setup.setGoal(goals);
  ASSERT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_NEAR(setup.getSolutionPath().length(), 3, 1e-9);
  setup.getPlanner()->clear();
  EXPECT_EQ(setup.getPlanner()->solve(ob::plannerAlwaysTerminatingCondition()),
            ob::PlannerStatus::TIMEOUT);
}

TEST(ExactDiscPlanner, ItsDataAreTheStatesOfThePath) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  setup.solve(ob::plannerNonTerminatingCondition());
  ob::PlannerData data(setup.getSpaceInformation());
  setup.getPlannerData(data);
  const std::size_t states = setup.getSolutionPath().getStateCount();
  EXPECT_EQ(data.numVertices(), states);
  EXPECT_EQ(data.numEdges(), states - 1);
  EXPECT_EQ(data.numStartVertices(), 1U);
  EXPECT_EQ(data.numGoalVertices(), 1U);
}

TEST(ExactDiscPlanner, RefusesStartsAndGoalsInObstaclesAndGoalsWithoutStates) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  const auto& space = setup.getStateSpace();
  const auto free = state_at(space, {0.6, 0.6}), blocked = state_at(space, {4.2, 4.4});
  setup.setStartAndGoalStates(blocked, free);
  setup.setup();
  EXPECT_EQ(setup.getPlanner()->solve(ob::plannerNonTerminatingCondition()),
            ob::PlannerStatus::INVALID_START);
  setup.setStartAndGoalStates(free, blocked);
  EXPECT_EQ(setup.getPlanner()->solve(ob::plannerNonTerminatingCondition()),
            ob::PlannerStatus::INVALID_GOAL);
  setup.setGoal(std::make_shared<ob::GoalLazySamples>(
      setup.getSpaceInformation(), [](const ob::GoalLazySamples*, ob::State*) { return false; },
      false));
  EXPECT_EQ(setup.getPlanner()->solve(ob::plannerNonTerminatingCondition()),
            ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}

/// The text of the ompl::Exception of an action; "" if there was none.
template <typename Action>
std::string exception_text(Action action) {
  try {
    action();
  } catch (const ompl::Exception& e) {
    return e.what();
  }
  return "";
}

TEST(ExactDiscPlanner, RefusesOtherSpacesChecksAndObjectives) {
  ompl::msg::noOutputHandler();
  const World world = disc_world();
  auto in_space =
      std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
  EXPECT_NE(exception_text([&] {
              set_disc_checks(in_space, world, kRadius);
            }).find("expected R^2 or SE(2)"),
            std::string::npos);
  auto curves = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::DubinsStateSpace>(0.5));
  EXPECT_NE(exception_text([&] { set_disc_checks(curves, world, kRadius); }), "");

  const auto unknown =
      std::make_shared<ob::SpaceInformation>(make_disc_space(world, kRadius)->getStateSpace());
  EXPECT_NE(exception_text([&] { ExactDiscPlanner(unknown).setup(); }).find("set_disc_checks"),
            std::string::npos);

  og::SimpleSetup setup = exact_setup(world);
  setup.setOptimizationObjective(
      std::make_shared<ob::MaximizeMinClearanceObjective>(setup.getSpaceInformation()));
  EXPECT_NE(exception_text([&] {
              setup.solve(ob::plannerNonTerminatingCondition());
            }).find("expected the path length"),
            std::string::npos);
}

TEST(ExactDiscPlanner, ItsParameterBoundsTheExcessOfThePolyline) {
  const World world = disc_world();
  og::SimpleSetup setup = exact_setup(world);
  ASSERT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  const std::size_t fine = setup.getSolutionPath().getStateCount();
  setup.clear();
  ASSERT_TRUE(setup.getPlanner()->params().setParam("max_excess", "1e-3"));
  ASSERT_EQ(setup.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_LT(setup.getSolutionPath().getStateCount(), fine);
  EXPECT_LE(setup.getSolutionPath().length(), shortest_length(world) * (1 + 1e-3));
}

}  // namespace
}  // namespace slalom
