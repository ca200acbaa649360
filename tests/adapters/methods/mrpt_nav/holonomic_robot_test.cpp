// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

std::string straight_keys() {
  return "plugin = " + kBuild + "/lib/libstraight_holonomic.so\nclass = mine::CStraight\n";
}

std::unique_ptr<Method> load_holonomic(const std::string& keys, const RobotModel& robot) {
  const IniFile ini =
      IniFile::from_text("[method.a]\nadapter = mrpt_holonomic\n" + keys, "campaign.ini");
  return read_holonomic_method(ini, "method.a")(robot, {});
}

/// A run in a room of 10 m x 10 m to a goal 45 degrees to the left.
SimulationResult run_to_the_left(const std::string& keys, const RobotModel& robot,
                                 const Primitives& obstacles = {}) {
  const World world(Scenario::continuous("room", {0, 0, 10, 10}, obstacles, {2, 2, 0}, {7, 7}),
                    0.05);
  RunSetup setup;
  setup.robot = robot;
  return simulate(world, setup, 1, *load_holonomic(keys, robot));
}

RobotModel holonomic_robot() {
  RobotModel robot;
  robot.kinematics = Kinematics::Holonomic;
  return robot;
}

TEST(HolonomicPlugin, ClassOfAnMrptModuleReachesTheGoal) {
  const SimulationResult result = run_to_the_left(straight_keys(), {});
  EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
  for (const Sample& sample : result.trajectory.samples) EXPECT_EQ(sample.command_vy, 0);
}

TEST(HolonomicRobot, MovesStraightInTheDirectionOfTheClass) {
  for (const std::string turn : {"face", "keep"}) {
    const SimulationResult result =
        run_to_the_left(straight_keys() + "turn = " + turn + "\n", holonomic_robot());
    EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
    const auto& samples = result.trajectory.samples;
    EXPECT_NEAR(samples[0].command_v, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(samples[0].command_vy, std::sqrt(0.5), 1e-9);
    double max_heading = 0;
    for (const Sample& sample : samples) {
      // Along the diagonal; within a control cycle the velocity turns with the robot, by 0.15 rad.
      EXPECT_NEAR(sample.pose.y, sample.pose.x, turn == "face" ? 0.2 : 1e-9);
      max_heading = std::max(max_heading, sample.pose.phi);
    }
    EXPECT_NEAR(max_heading, turn == "face" ? std::atan(1) : 0, 0.05) << turn;
  }
}

TEST(HolonomicRobot, StopsBeforeAnObstacleInThatDirection) {
  Primitives disc;
  disc.discs = {{{4, 4}, 0.5}};
  const SimulationResult result = run_to_the_left(straight_keys(), holonomic_robot(), disc);
  EXPECT_EQ(result.outcome, Outcome::Stuck) << result.detail;
  const auto& end = result.trajectory.samples.back().pose;
  // Contact at a distance of 0.75 m, stop margin 0.05 m; the speed decreases asymptotically.
  EXPECT_GT(std::hypot(end.x - 4, end.y - 4), 0.79);
  EXPECT_LT(std::hypot(end.x - 4, end.y - 4), 0.9);
}

TEST(HolonomicRobot, DoesNotMoveBackwardsIfForwardOnly) {
  const World world(Scenario::continuous("room", {0, 0, 10, 10}, {}, {5, 5, 0}, {2, 5.5}), 0.05);
  for (const bool forward_only : {true, false}) {
    RunSetup setup;
    setup.robot = holonomic_robot();
    setup.robot.forward_only = forward_only;
    const auto result = simulate(world, setup, 1, *load_holonomic(straight_keys(), setup.robot));
    EXPECT_EQ(result.outcome, Outcome::Success) << result.detail;
    EXPECT_EQ(result.trajectory.samples[0].command_v < 0, !forward_only);
  }
}

TEST(HolonomicRobot, EachMrptClassPassesADisc) {
  Primitives disc;
  disc.discs = {{{4.3, 4}, 0.4}};
  for (const std::string name : {"CHolonomicND", "CHolonomicFullEval"}) {
    const auto result = run_to_the_left("class = " + name + "\n", holonomic_robot(), disc);
    EXPECT_EQ(result.outcome, Outcome::Success) << name << ": " << result.detail;
  }
}

}  // namespace
}  // namespace slalom
