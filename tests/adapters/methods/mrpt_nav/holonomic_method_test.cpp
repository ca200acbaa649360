// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/robot/diff_drive.h>
#include <slalom/scenario/world.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kPeriod = 0.1;  // s
const char* const kClasses[] = {"CHolonomicND", "CHolonomicVFF", "CHolonomicFullEval"};

std::unique_ptr<Method> load(const std::string& keys, const RobotModel& robot = {}) {
  const IniFile ini =
      IniFile::from_text("[method.a]\nadapter = mrpt_holonomic\n" + keys, "campaign.ini");
  return read_holonomic_method(ini, "method.a")(robot, {});
}

/// A section with this key, in line 3, is refused with an error about the key.
testing::AssertionResult refuses(const std::string& key, const std::string& value,
                                 std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, "campaign.ini:3: [method.a] " + key + ": ", words,
                      [&] { load(key + " = " + value + "\n"); });
}

/// A room of 10 m x 10 m.
World room(const Primitives& obstacles = {}) {
  return {Scenario::continuous("room", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5}), 0.05};
}

World room_with_discs() {
  Primitives obstacles;
  obstacles.discs = {{{4, 5.2}, 0.5}, {{6.5, 3.8}, 0.4}};
  return room(obstacles);
}

mrpt::obs::CObservation2DRangeScan scan_from(const World& world, const mrpt::math::TPose2D& pose) {
  const SensorModel sensor;
  const ScanGeometry geometry{sensor.rays, sensor.aperture(), sensor.max_range};
  std::vector<float> ranges(static_cast<std::size_t>(sensor.rays));
  world.ray_caster().cast_scan(pose, geometry, ranges.data());
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(sensor.aperture());
  scan.maxRange = static_cast<float>(sensor.max_range);
  scan.resizeScan(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.setScanRange(i, ranges[i]);
    scan.setScanRangeValidity(i, ranges[i] < scan.maxRange);
  }
  return scan;
}

struct RunResult {
  std::vector<double> commands;  ///< v, w of each cycle
  double goal_distance = 0;      ///< m, at the end
  double clearance = 0;          ///< m, smallest
};

/// A run of at most `cycles` from the start of `world` to `goal`; every command must be valid.
RunResult run(Method& method, const World& world, const mrpt::math::TPoint2D& goal, int cycles) {
  const RobotModel robot;
  DiffDrive vehicle(robot);
  vehicle.start_at(world.scenario().start());
  NavigationTask task;
  task.start = world.scenario().start();
  task.goal = goal;
  task.goal_tolerance = 0.2;
  task.control_period = kPeriod;
  method.reset(task);
  RunResult result;
  result.clearance = 1e9;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const mrpt::math::TPose2D pose = vehicle.getCurrentGTPose();
    result.goal_distance = std::hypot(goal.x - pose.x, goal.y - pose.y);
    result.clearance =
        std::min(result.clearance, world.distance_field().clearance({pose.x, pose.y}));
    if (result.goal_distance < task.goal_tolerance) break;
    const auto scan = scan_from(world, pose);
    Observation observation;
    observation.time = cycle * kPeriod;
    observation.odometry = pose;
    observation.v = vehicle.v();
    observation.w = vehicle.w();
    observation.goal_in_robot = pose.inverseComposePoint(goal);
    observation.scan = &scan;
    const Command command = method.step(observation);
    std::string why;
    EXPECT_TRUE(is_valid_command(command, robot, why)) << why << " in cycle " << cycle;
    result.commands.insert(result.commands.end(), {command.v, command.w});
    vehicle.command(command.v, command.w);
    for (int i = 0; i < 10; ++i) vehicle.advance(kPeriod / 10);
  }
  return result;
}

TEST(HolonomicMethod, EachMrptClassReachesTheGoalInFreeSpace) {
  const World world = room();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    // Up to 8 m at up to 1 m/s; some slow down long before the goal.
    for (const mrpt::math::TPoint2D& goal : {mrpt::math::TPoint2D{8, 5}, {6, 8}, {5, 2}}) {
      const RunResult result = run(*method, world, goal, 400);
      EXPECT_LT(result.goal_distance, 0.2) << goal.x << ' ' << goal.y;
    }
  }
}

TEST(HolonomicMethod, EachMrptClassAvoidsObstacles) {
  const World world = room_with_discs();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const RunResult result = run(*method, world, {8, 5}, 300);
    EXPECT_GT(result.clearance, RobotModel{}.radius);
    // The force field gets stuck in front of the first disc, the others pass both.
    EXPECT_LT(result.goal_distance, name == "CHolonomicVFF" ? 6 : 0.2);
  }
}

TEST(HolonomicMethod, SlowsDownAtTheDistanceToTheGoalInMeters) {
  for (const std::string name : {"CHolonomicND", "CHolonomicFullEval"})
    for (const std::string reference : {"2", "3", "5"}) {
      SCOPED_TRACE(name + " " + reference);
      const auto method =
          load("class = " + name + "\nconfig_set = " + name +
               ".TARGET_SLOW_APPROACHING_DISTANCE=1\nreference_distance = " + reference + "\n");
      const auto speed_at = [&](double distance) {
        return run(*method, room(), {1 + distance, 5}, 1).commands[0];
      };
      EXPECT_GT(speed_at(1.05), 0.95);
      EXPECT_NEAR(speed_at(0.6), 0.6 * speed_at(1.05), 0.07);
    }
}

TEST(HolonomicMethod, RotatesTowardsAGoalBehindOrBeside) {
  const World world = room();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const RunResult left = run(*method, world, {1, 8}, 1);
    EXPECT_EQ(left.commands[0], 0);
    EXPECT_GT(left.commands[1], 0);
    const RunResult right = run(*method, world, {1, 2}, 1);
    EXPECT_EQ(right.commands[0], 0);
    EXPECT_LT(right.commands[1], 0);
  }
}

TEST(HolonomicMethod, DoesNotTurnInPlaceWhileTheRobotStillMoves) {
  const World world = room();
  const mrpt::math::TPose2D pose = world.scenario().start();
  const auto scan = scan_from(world, pose);
  NavigationTask task;
  task.control_period = kPeriod;
  const auto method = load("class = CHolonomicND\n");
  const double stops = RobotModel{}.max_accel_v * kPeriod;  // m/s, within one period
  for (const double v : {0.0, 0.99 * stops, 1.01 * stops, 0.9}) {
    method->reset(task);
    Observation observation;
    observation.odometry = pose;
    observation.v = v;
    observation.goal_in_robot = {0, 3};
    observation.scan = &scan;
    const Command command = method->step(observation);
    EXPECT_EQ(command.v, 0) << v;
    EXPECT_EQ(command.w > 0, v < stops) << v;
  }
}

TEST(HolonomicMethod, RunsAreIndependent) {
  const World empty = room(), discs = room_with_discs();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const RunResult first = run(*method, discs, {8, 5}, 60);
    run(*method, empty, {3, 9}, 25);
    EXPECT_EQ(run(*method, discs, {8, 5}, 60).commands, first.commands);
    const auto fresh = load("class = " + name + "\n");
    EXPECT_EQ(run(*fresh, discs, {8, 5}, 60).commands, first.commands);
  }
}

TEST(HolonomicMethod, DoesNotMoveTowardsACloseWall) {
  // The robot of radius 0.25 m, 0.29 m from a wall: within the stop margin of 0.05 m.
  Primitives wall;
  wall.polygons.push_back({{{1.3, 0}, {1.5, 0}, {1.5, 10}, {1.3, 10}}});
  const World world = room(wall);
  for (const std::string name : kClasses)
    EXPECT_EQ(run(*load("class = " + name + "\n"), world, {8, 5}, 1).commands[0], 0) << name;
}

TEST(HolonomicMethod, AcceptsANameWithOrWithoutNamespace) {
  EXPECT_NE(load("class = mrpt::nav::CHolonomicVFF\n"), nullptr);
  EXPECT_NE(load("class = CHolonomicVFF\n"), nullptr);
  EXPECT_NE(load(""), nullptr);
}

TEST(HolonomicMethod, ListsTheKnownClassesForAnUnknownOne) {
  for (const std::string name : kClasses)
    EXPECT_TRUE(refuses("class", "CHolonomicNd",
                        {"'CHolonomicNd'; expected one of ", "mrpt::nav::" + name}));
  // An MRPT class that is not a holonomic method.
  EXPECT_TRUE(refuses("class", "mrpt::obs::CObservation2DRangeScan", {"expected one of"}));
}

TEST(HolonomicMethod, IsMadeFromOptionsOfAProgram) {
  const World world = room_with_discs();
  const auto from_ini = load("class = CHolonomicVFF\nmargin = 0.1\n");
  HolonomicOptions options;
  options.class_name = "CHolonomicVFF";
  options.margin = 0.1;
  const auto from_program = mrpt_holonomic(options)({}, {});
  EXPECT_EQ(run(*from_program, world, {9, 5}, 100).commands,
            run(*from_ini, world, {9, 5}, 100).commands);
  EXPECT_NE(mrpt_holonomic("CHolonomicND")({}, {}), nullptr);
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "mrpt_holonomic.class: ", {"'CHolonomicXY'", "CHolonomicND"},
                           [] { mrpt_holonomic("CHolonomicXY")({}, {}); }));
  options.sectors = 1;
  EXPECT_TRUE(throws_error(ErrorKind::Usage,
                           "mrpt_holonomic.sectors: ", {"'1'", "expected an integer in [8, 2000]"},
                           [&] { mrpt_holonomic(options); }));
}

TEST(HolonomicMethod, RefusesUnknownKeysAndInvalidValues) {
  EXPECT_TRUE(refuses("sector", "100", {"'sectors'"}));
  EXPECT_TRUE(refuses("sectors", "4", {}));
  EXPECT_TRUE(refuses("behind", "walls", {}));
}

TEST(HolonomicMethod, OverridesTheDefaultsOfTheClass) {
  const World world = room_with_discs();
  const auto commands = [&](const std::string& options) {
    return run(*load("class = CHolonomicND\n" + options), world, {9, 5}, 100).commands;
  };
  const std::string key = "config_set = CHolonomicND.RISK_EVALUATION_DISTANCE=";
  EXPECT_EQ(commands(key + "0.4\n"), commands(""));  // the default
  EXPECT_NE(commands(key + "1\n"), commands(""));
  EXPECT_TRUE(refuses("config_set", "CHolonomicND.RISK_DISTANCE=1",
                      {"nobody reads RISK_DISTANCE in [CHolonomicND]"}));
}

TEST(HolonomicMethod, RefusesMissingFiles) {
  EXPECT_TRUE(refuses("config", "/nowhere/nd.ini",
                      {"config '/nowhere/nd.ini' not found", "expected a file"}));
  EXPECT_TRUE(refuses("plugin", "/nowhere/libplugin.so",
                      {"library '/nowhere/libplugin.so' not found", "expected a file"}));
}

}  // namespace
}  // namespace slalom
