// Properties of these methods that are known from the literature, each in its own scenario, with
// the simulator and the plug-ins.
#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <string>

namespace slalom {
namespace {

struct IncludedMethod {
  const char* name;
  const char* keys;
};

#define SLALOM_LIBRARY(NAME) \
  "adapter = library\nplugin = " SLALOM_PLUGIN_FOLDER "/libslalom_" NAME ".so\n"
#define SLALOM_HOLONOMIC(NAME, CLASS)                                           \
  "adapter = mrpt_holonomic\nplugin = " SLALOM_PLUGIN_FOLDER "/libslalom_" NAME \
  ".so\nclass = "                                                               \
  "slalom::" CLASS "\n"

constexpr IncludedMethod kGoToGoal = {"go_to_goal", SLALOM_LIBRARY("go_to_goal")};
constexpr IncludedMethod kDwa = {"dwa", SLALOM_LIBRARY("dwa")};
constexpr IncludedMethod kGuidedDwa = {"guided dwa", SLALOM_LIBRARY("dwa") "guidance = 1\n"};
constexpr IncludedMethod kRollout = {"trajectory_rollout", SLALOM_LIBRARY("trajectory_rollout")};
constexpr IncludedMethod kMppi = {"mppi", SLALOM_LIBRARY("mppi") "samples = 200\n"};
constexpr IncludedMethod kVfhPlus = {"vfh_plus", SLALOM_HOLONOMIC("vfh_plus", "CHolonomicVFHPlus")};
constexpr IncludedMethod kSmoothNd = {"smooth_nd",
                                      SLALOM_HOLONOMIC("smooth_nd", "CHolonomicSmoothND")};
constexpr IncludedMethod kNdPlus = {"nd_plus", SLALOM_HOLONOMIC("nd_plus", "CHolonomicNDPlus")};
constexpr IncludedMethod kGap = {
    "follow_the_gap_holonomic",
    SLALOM_HOLONOMIC("follow_the_gap_holonomic", "CHolonomicFollowTheGap")};
constexpr IncludedMethod kField = {"potential_field",
                                   SLALOM_HOLONOMIC("potential_field", "CHolonomicPotentialField")};
constexpr IncludedMethod kMrptNd = {"CHolonomicND",
                                    "adapter = mrpt_holonomic\nclass = CHolonomicND\n"};
constexpr IncludedMethod kMrptVff = {"CHolonomicVFF",
                                     "adapter = mrpt_holonomic\nclass = CHolonomicVFF\n"};

/// Returns the outcome of a run: "success", "stuck", ...
std::string outcome(const IncludedMethod& method, const World& world) {
  const IniFile ini = IniFile::from_text("[method.a]\n" + std::string(method.keys), "campaign.ini");
  RunSetup setup;
  const bool library = std::string(method.keys).find("= library") != std::string::npos;
  const MethodReader read = library ? read_library_method : read_holonomic_method;
  const auto made = read(ini, "method.a")(setup.robot, setup.sensor);
  return to_string(simulate(world, setup, 1, *made).outcome);
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

/// A wall with a door of 1 m, for a robot 0.5 m wide.
World door() {
  return world_with_walls("door", {box(5, 0, 5.2, 3.5), box(5, 4.5, 5.2, 8)});
}

TEST(Behavior, EveryMethodReachesTheGoalInAnEmptyRoom) {
  const World world = empty_room();
  for (const IncludedMethod& method :
       {kGoToGoal, kDwa, kGuidedDwa, kRollout, kMppi, kVfhPlus, kSmoothNd, kNdPlus, kGap, kField})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behavior, EveryAvoidanceMethodPassesAPost) {
  const World world = post();
  EXPECT_EQ(outcome(kGoToGoal, world), "collision");
  for (const IncludedMethod& method :
       {kDwa, kGuidedDwa, kRollout, kMppi, kVfhPlus, kSmoothNd, kNdPlus, kGap})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
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
  for (const IncludedMethod& method : {kGuidedDwa, kRollout, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behavior, ADoorIsBlockedForForceFieldsAndPassedByNearnessDiagrams) {
  // Koren and Borenstein 1991: no passage between closely spaced obstacles. Minguez and Montano
  // 2004: ND passes.
  const World world = door();
  EXPECT_EQ(outcome(kMrptVff, world), "stuck");
  for (const IncludedMethod& method : {kNdPlus, kSmoothNd, kVfhPlus, kDwa, kRollout, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(IncludedIni, OfEachHolonomicMethodIsAccepted) {
  for (const IncludedMethod& method : {kVfhPlus, kSmoothNd, kNdPlus, kGap, kField}) {
    const std::string name = method.name;
    const std::string config =
        "config = " SLALOM_REACTIVE_FOLDER "/" + name + "/" + name + ".ini\n";
    const IniFile ini =
        IniFile::from_text("[method.a]\n" + std::string(method.keys) + config, "campaign.ini");
    EXPECT_NO_THROW(read_holonomic_method(ini, "method.a")({}, {})) << name;
  }
}

TEST(IncludedIni, OfEachLibraryIsAcceptedAndHasTheDefaults) {
  const World world = post();
  for (const IncludedMethod& method : {kGoToGoal, kDwa, kRollout}) {
    const std::string name = method.name;
    IniFile ini = IniFile::load(SLALOM_REACTIVE_FOLDER "/" + name + "/" + name + ".ini");
    const std::string section = "method." + name;
    ini.set(section, "plugin", SLALOM_PLUGIN_FOLDER "/libslalom_" + name + ".so");
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

}  // namespace
}  // namespace slalom
