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
  return make_holonomic_method({ini, "method.a", robot, {}});
}

std::string refusal(const std::string& keys) {
  return error_text(Culprit::Usage, [&] { load(keys); });
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

struct Drive {
  std::vector<double> commands;  ///< v, w of each cycle
  double goal_distance = 0;      ///< m, at the end
  double clearance = 0;          ///< m, smallest
};

/// A run of `cycles` at most from the start of `world` to `goal`; every command must be valid.
Drive drive(Method& method, const World& world, const mrpt::math::TPoint2D& goal, int cycles) {
  const RobotModel robot;
  DiffDrive vehicle(robot);
  vehicle.start_at(world.scenario().start());
  Task task;
  task.start = world.scenario().start();
  task.goal = goal;
  task.goal_tolerance = 0.2;
  task.control_period = kPeriod;
  method.reset(task);
  Drive result;
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

TEST(HolonomicMethod, EachOfMrptsClassesDrivesToTheGoalInFreeSpace) {
  const World world = room();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    // 8 m at up to 1 m/s; some slow down long before the goal.
    for (const mrpt::math::TPoint2D& goal : {mrpt::math::TPoint2D{8, 5}, {6, 8}, {5, 2}}) {
      const Drive result = drive(*method, world, goal, 400);
      EXPECT_LT(result.goal_distance, 0.2) << goal.x << ' ' << goal.y;
    }
  }
}

TEST(HolonomicMethod, EachOfMrptsClassesKeepsOffWhatStandsInTheWay) {
  const World world = room_with_discs();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const Drive result = drive(*method, world, {8, 5}, 300);
    EXPECT_GT(result.clearance, RobotModel{}.radius);
    // A force field comes to rest in front of the first disc, the others get round both.
    EXPECT_LT(result.goal_distance, name == "CHolonomicVFF" ? 6 : 0.2);
  }
}

TEST(HolonomicMethod, TurnsTowardsAGoalBehindOrAside) {
  const World world = room();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const Drive left = drive(*method, world, {1, 8}, 1);
    EXPECT_EQ(left.commands[0], 0);
    EXPECT_GT(left.commands[1], 0);
    const Drive right = drive(*method, world, {1, 2}, 1);
    EXPECT_EQ(right.commands[0], 0);
    EXPECT_LT(right.commands[1], 0);
  }
}

TEST(HolonomicMethod, NothingOfOneRunShowsInTheNext) {
  const World empty = room(), discs = room_with_discs();
  for (const std::string name : kClasses) {
    SCOPED_TRACE(name);
    const auto method = load("class = " + name + "\n");
    const Drive first = drive(*method, discs, {8, 5}, 60);
    drive(*method, empty, {3, 9}, 25);
    EXPECT_EQ(drive(*method, discs, {8, 5}, 60).commands, first.commands);
    const auto fresh = load("class = " + name + "\n");
    EXPECT_EQ(drive(*fresh, discs, {8, 5}, 60).commands, first.commands);
  }
}

TEST(HolonomicMethod, StandsStillBeforeAWall) {
  // The robot of radius 0.25 m, 0.29 m before a wall: nearer than the stop margin of 0.05 m.
  Primitives wall;
  wall.polygons.push_back({{{1.3, 0}, {1.5, 0}, {1.5, 10}, {1.3, 10}}});
  const World world = room(wall);
  for (const std::string name : kClasses)
    EXPECT_EQ(drive(*load("class = " + name + "\n"), world, {8, 5}, 1).commands[0], 0) << name;
}

TEST(HolonomicMethod, TakesANameWithOrWithoutItsNamespace) {
  EXPECT_NE(load("class = mrpt::nav::CHolonomicVFF\n"), nullptr);
  EXPECT_NE(load("class = CHolonomicVFF\n"), nullptr);
  EXPECT_NE(load(""), nullptr);
}

TEST(HolonomicMethod, NamesTheClassesThereAreForOneThatIsNot) {
  const std::string text = refusal("class = CHolonomicNd\n");
  EXPECT_EQ(text.rfind("campaign.ini:3: [method.a] class: no holonomic method class "
                       "'CHolonomicNd'; expected one of ",
                       0),
            0U)
      << text;
  for (const std::string name : kClasses)
    EXPECT_NE(text.find("mrpt::nav::" + name), std::string::npos) << text;
  // A class of MRPT that is something else.
  EXPECT_NE(refusal("class = mrpt::obs::CObservation2DRangeScan\n").find("expected one of"),
            std::string::npos);
}

TEST(HolonomicMethod, RefusesKeysAndValuesThatItDoesNotKnow) {
  EXPECT_NE(refusal("sector = 100\n").find("'sectors'"), std::string::npos)
      << refusal("sector = 100\n");
  EXPECT_EQ(refusal("sectors = 4\n").rfind("campaign.ini:3: [method.a] sectors: ", 0), 0U);
  EXPECT_EQ(refusal("behind = walls\n").rfind("campaign.ini:3: [method.a] behind: ", 0), 0U);
}

TEST(HolonomicMethod, RefusesFilesThatAreNotThere) {
  EXPECT_EQ(refusal("config = /nowhere/nd.ini\n"),
            "campaign.ini:3: [method.a] config: '/nowhere/nd.ini' cannot be read; expected an MRPT "
            ".ini");
  const std::string plugin = refusal("plugin = /nowhere/libplugin.so\n");
  EXPECT_EQ(plugin.rfind("campaign.ini:3: [method.a] plugin: cannot be loaded (/nowhere/", 0), 0U)
      << plugin;
}

}  // namespace
}  // namespace slalom
