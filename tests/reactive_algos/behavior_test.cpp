// SPDX-License-Identifier: BSD-3-Clause
// Properties of these methods that are known from the literature, each in its own scenario, with
// the simulator and the plug-ins.
#include "places.h"

#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/mrpt_nav/navigator_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <string>

namespace slalom {
namespace {

struct IncludedMethod {
  const char* name;
  std::string keys;
};

std::string library(const std::string& name) {
  return "adapter = library\nplugin = " + kMethods + "/libslalom_" + name + ".so\n";
}
std::string holonomic(const std::string& name, const std::string& class_name) {
  return "adapter = mrpt_holonomic\nplugin = " + kMethods + "/libslalom_" + name +
         ".so\nclass = slalom::" + class_name + "\n";
}

const IncludedMethod kGoToGoal = {"go_to_goal", library("go_to_goal")};
const IncludedMethod kDwa = {"dwa", library("dwa")};
const IncludedMethod kGuidedDwa = {"guided dwa", library("dwa") + "guidance = 1\n"};
const IncludedMethod kRollout = {"trajectory_rollout", library("trajectory_rollout")};
const IncludedMethod kRolloutTracks = {"rollout_tracks", library("rollout_tracks")};
const IncludedMethod kRosDwa = {"dwa_local_planner", library("dwa_local_planner")};
const IncludedMethod kPursuit = {"regulated_pure_pursuit", library("regulated_pure_pursuit")};
const IncludedMethod kElasticBand = {"eband_local_planner", library("eband_local_planner")};
const IncludedMethod kMppi = {"mppi", library("mppi") + "samples = 200\n"};
const IncludedMethod kVfhPlus = {"vfh_plus", holonomic("vfh_plus", "CHolonomicVFHPlus")};
const IncludedMethod kSmoothNd = {"smooth_nd", holonomic("smooth_nd", "CHolonomicSmoothND")};
const IncludedMethod kNdPlus = {"nd_plus", holonomic("nd_plus", "CHolonomicNDPlus")};
const IncludedMethod kGap = {"follow_the_gap_holonomic",
                             holonomic("follow_the_gap_holonomic", "CHolonomicFollowTheGap")};
const IncludedMethod kField = {"potential_field",
                               holonomic("potential_field", "CHolonomicPotentialField")};
const IncludedMethod kMrptNd = {"CHolonomicND", "adapter = mrpt_holonomic\nclass = CHolonomicND\n"};
const IncludedMethod kMrptVff = {"CHolonomicVFF",
                                 "adapter = mrpt_holonomic\nclass = CHolonomicVFF\n"};

SimulationResult run_of(const IncludedMethod& method, const World& world,
                        const RobotModel& robot = {}) {
  const IniFile ini = IniFile::from_text("[method.a]\n" + std::string(method.keys), "campaign.ini");
  RunSetup setup;
  setup.robot = robot;
  const std::string adapter = ini.get("method.a", "adapter").value_or("");
  const MethodReader read = adapter == "library"          ? read_library_method
                            : adapter == "mrpt_navigator" ? read_navigator_method
                                                          : read_holonomic_method;
  const auto made = read(ini, "method.a")(setup.robot, setup.sensor);
  return simulate(world, setup, 1, *made);
}

/// Returns the outcome of a run: "success", "stuck", ...
std::string outcome(const IncludedMethod& method, const World& world,
                    const RobotModel& robot = {}) {
  return to_string(run_of(method, world, robot).outcome);
}

Trajectory trajectory_of(const IncludedMethod& method, const World& world) {
  return run_of(method, world).trajectory;
}

Polygon box(double x1, double y1, double x2, double y2) {
  return {{{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}}};
}

World world_with_walls(const std::string& name, const std::vector<Polygon>& walls) {
  Primitives obstacles;
  obstacles.polygons = walls;
  return {Scenario::continuous(name, {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9, 4}), 0.05};
}

World empty_room() {
  return world_with_walls("empty", {});
}

/// A post near the straight line to the goal.
World post() {
  Primitives obstacles;
  obstacles.discs.push_back({{4.8, 3.5}, 0.4});
  return {Scenario::continuous("post", {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9, 4}), 0.05};
}

/// A U-shaped obstacle that is open towards the start, between robot and goal.
World u_trap() {
  return world_with_walls("trap", {box(6, 2.8, 6.2, 5.2), box(4, 2.8, 6, 3), box(4, 5, 6, 5.2)});
}

/// A wall with a door, by default of 1 m for a robot 0.5 m wide.
World door(double width = 1) {
  return world_with_walls("door",
                          {box(5, 0, 5.2, 4 - 0.5 * width), box(5, 4 + 0.5 * width, 5.2, 8)});
}

/// The rectangle of a Jackal, 0.42 m x 0.33 m; its enclosing disc has a diameter of 0.534 m.
RobotModel jackal() {
  RobotModel robot;
  robot.footprint = "0.21,0.165; -0.21,0.165; -0.21,-0.165; 0.21,-0.165";
  robot.max_v = 0.5;
  robot.set_radius_of_footprint("robot");
  return robot;
}

TEST(Behavior, EveryMethodReachesTheGoalInAnEmptyRoom) {
  const World world = empty_room();
  for (const IncludedMethod& method :
       {kGoToGoal, kDwa, kRosDwa, kGuidedDwa, kRollout, kPursuit, kElasticBand, kMppi, kVfhPlus,
        kSmoothNd, kNdPlus, kGap, kField})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behavior, EveryAvoidanceMethodPassesAPost) {
  const World world = post();
  EXPECT_EQ(outcome(kGoToGoal, world), "collision");
  for (const IncludedMethod& method : {kDwa, kRosDwa, kGuidedDwa, kRollout, kPursuit, kElasticBand,
                                       kMppi, kVfhPlus, kSmoothNd, kNdPlus, kGap})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behavior, APotentialFieldPassesAPost) {
  const std::string keys = std::string(kField.keys) + "turn_in_place = 1.5\n";
  EXPECT_EQ(outcome({"with wide turns", keys.c_str()}, post()), "success");
}

TEST(Behavior, AUShapedObstacleTrapsMethodsWithoutPathPlanning) {
  // Koren and Borenstein 1991: a potential field has a local minimum there. A dynamic window and no
  // avoidance fail, too.
  const World world = u_trap();
  EXPECT_EQ(outcome(kGoToGoal, world), "collision");
  EXPECT_EQ(outcome(kField, world), "stuck");
  EXPECT_EQ(outcome(kDwa, world), "stuck");
}

TEST(Behavior, ANavigationFunctionLeadsOutOfAUShapedObstacle) {
  // Brock and Khatib 1999: with a navigation function on the local map there is no local minimum.
  const World world = u_trap();
  for (const IncludedMethod& method :
       {kGuidedDwa, kRosDwa, kRollout, kPursuit, kElasticBand, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behavior, ADoorIsBlockedForForceFieldsAndPassedByNearnessDiagrams) {
  // Koren and Borenstein 1991: no passage between closely spaced obstacles. Minguez and Montano
  // 2004: ND passes.
  const World world = door();
  EXPECT_EQ(outcome(kMrptVff, world), "stuck");
  for (const IncludedMethod& method :
       {kNdPlus, kSmoothNd, kVfhPlus, kDwa, kRosDwa, kRollout, kPursuit, kElasticBand, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

/// The table of docs/methods/methods.md. The reference distance is that of each trajectory
/// generator.
TEST(Behavior, WhetherCHolonomicNDPassesADoorDependsOnWhatSurroundsIt) {
  const std::string nd = kMrptNd.keys;
  const std::string distance = "refDistance=3; CReactiveNavigationSystem.PTG";
  const std::string navigator =
      "adapter = mrpt_navigator\n"
      "config = /usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini\n"
      "config_set = CAbstractPTGBasedReactive.holonomic_method=CHolonomicND; "
      "CAbstractPTGBasedReactive.ref_distance=3; CReactiveNavigationSystem.PTG0_" +
      distance + "1_" + distance + "2_refDistance=3\n";
  const World narrow = door(0.9), wide = door(1), wider = door(1.2);  // 0.8, 0.9, 1.1 m are free
  const auto outcome_of = [](const std::string& keys, const World& world) {
    return outcome({"CHolonomicND", keys.c_str()}, world);
  };
  EXPECT_EQ(outcome_of(nd, wide), "timeout");
  EXPECT_EQ(outcome_of(nd, wider), "success");
  for (const std::string change :
       {"sectors = 361\n", "reference_distance = 2\n", "behind = blocked\n"}) {
    EXPECT_EQ(outcome_of(nd + change, narrow), "stuck") << change;
    EXPECT_EQ(outcome_of(nd + change, wide), "success") << change;
  }
  EXPECT_EQ(outcome_of(nd + "margin = 0.02\n", narrow), "success");
  EXPECT_EQ(outcome_of(navigator, narrow), "success");
}

TEST(Behavior, AFootprintPassesADoorThatIsTooNarrowForItsEnclosingDisc) {
  RobotModel disc = jackal();
  disc.footprint = "";
  const World world = door(0.65);  // obstacles are cells of 0.05 m: 0.6 m are free
  for (const IncludedMethod& method : {kDwa, kGuidedDwa, kRollout, kPursuit, kMppi})
    EXPECT_EQ(outcome(method, world, jackal()), "success") << method.name;
  EXPECT_EQ(outcome(kRollout, world, disc), "stuck");
}

/// Two walkers that come towards the robot, one behind the other, and one across.
World walkers() {
  const World room = empty_room();
  const Movers movers = {{"a", 0.3, {{0, {9, 4.1}}, {20, {-7, 4.1}}}, MoverEnd::Vanish},
                         {"b", 0.3, {{0, {11.5, 3.8}}, {20, {-4.5, 3.8}}}, MoverEnd::Vanish},
                         {"c", 0.3, {{0, {6, -3}}, {20, {6, 17}}}, MoverEnd::Vanish}};
  return {room.scenario().with_movers(movers), 0.05};
}

TEST(Behavior, TracksHelpToEvadeWalkersThatDoNotGiveWay) {
  const World world = walkers();
  EXPECT_EQ(outcome(kDwa, world), "collision");
  EXPECT_EQ(outcome(kRollout, world), "collision");
  EXPECT_EQ(outcome(kRolloutTracks, world), "success");
  // The method equals trajectory_rollout if there are no movers.
  for (const World& still : {post(), door(), u_trap()})
    EXPECT_EQ(trajectory_of(kRolloutTracks, still).hash(), trajectory_of(kRollout, still).hash());
}

TEST(IncludedIni, OfEachHolonomicMethodIsAccepted) {
  for (const IncludedMethod& method : {kVfhPlus, kSmoothNd, kNdPlus, kGap, kField}) {
    const std::string name = method.name;
    const std::string config = "config = " + kReactiveAlgos + "/" + name + "/" + name + ".ini\n";
    const IniFile ini =
        IniFile::from_text("[method.a]\n" + std::string(method.keys) + config, "campaign.ini");
    EXPECT_NO_THROW(read_holonomic_method(ini, "method.a")({}, {})) << name;
  }
}

TEST(IncludedIni, OfEachLibraryIsAcceptedAndHasTheDefaults) {
  const World world = post();
  for (const IncludedMethod& method :
       {kGoToGoal, kDwa, kRosDwa, kRollout, kPursuit, kElasticBand, kRolloutTracks}) {
    const std::string name = method.name;
    IniFile ini = IniFile::load(kReactiveAlgos + "/" + name + "/" + name + ".ini");
    const std::string section = "method." + name;
    ini.set(section, "plugin", kMethods + "/libslalom_" + name + ".so");
    const RunSetup setup;
    const auto with_ini = read_library_method(ini, section)(setup.robot, setup.sensor);
    const IniFile bare =
        IniFile::from_text("[method.a]\n" + std::string(method.keys), "campaign.ini");
    const auto without = read_library_method(bare, "method.a")(setup.robot, setup.sensor);
    const auto first = simulate(world, setup, 1, *with_ini).trajectory.samples;
    const auto second = simulate(world, setup, 1, *without).trajectory.samples;
    ASSERT_EQ(first.size(), second.size()) << name;
    EXPECT_EQ(first.back().numbers(), second.back().numbers()) << name;
  }
}

TEST(Behavior, AllTurnAtAGoalToItsHeading) {
  const World world(empty_room().scenario().with_goal_heading(2.5), 0.05);
  for (const IncludedMethod& method :
       {kGoToGoal, kDwa, kRollout, kRolloutTracks, kRosDwa, kPursuit, kElasticBand, kMppi, kVfhPlus,
        kSmoothNd, kNdPlus, kGap, kField, kMrptNd, kMrptVff}) {
    const SimulationResult result = run_of(method, world);
    EXPECT_EQ(result.outcome, Outcome::Success) << method.name << ": " << result.detail;
    const double error = result.trajectory.samples.back().pose.phi - 2.5;
    EXPECT_LE(std::abs(std::remainder(error, 2 * M_PI)), 0.25) << method.name;
  }
}

}  // namespace
}  // namespace slalom
