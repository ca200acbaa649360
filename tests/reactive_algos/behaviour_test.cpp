// What the literature says of these methods, each claim on a place made for it, through the
// simulator, with the plug-ins as users load them.
#include <slalom/library/library_method.h>
#include <slalom/mrpt_nav/holonomic_method.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

#include <string>

namespace slalom {
namespace {

struct Shipped {
  const char* name;
  const char* keys;
};

#define SLALOM_LIBRARY(NAME) \
  "adapter = library\nplugin = " SLALOM_PLUGIN_FOLDER "/libslalom_" NAME ".so\n"
#define SLALOM_HOLONOMIC(NAME, CLASS)                                           \
  "adapter = mrpt_holonomic\nplugin = " SLALOM_PLUGIN_FOLDER "/libslalom_" NAME \
  ".so\nclass = "                                                               \
  "slalom::" CLASS "\n"

constexpr Shipped kGoToGoal = {"go_to_goal", SLALOM_LIBRARY("go_to_goal")};
constexpr Shipped kDwa = {"dwa", SLALOM_LIBRARY("dwa")};
constexpr Shipped kGuidedDwa = {"guided dwa", SLALOM_LIBRARY("dwa") "guidance = 1\n"};
constexpr Shipped kRollout = {"trajectory_rollout", SLALOM_LIBRARY("trajectory_rollout")};
constexpr Shipped kMppi = {"mppi", SLALOM_LIBRARY("mppi") "samples = 200\n"};
constexpr Shipped kVfhPlus = {"vfh_plus", SLALOM_HOLONOMIC("vfh_plus", "CHolonomicVFHPlus")};
constexpr Shipped kSmoothNd = {"smooth_nd", SLALOM_HOLONOMIC("smooth_nd", "CHolonomicSmoothND")};
constexpr Shipped kNdPlus = {"nd_plus", SLALOM_HOLONOMIC("nd_plus", "CHolonomicNDPlus")};
constexpr Shipped kGap = {"follow_the_gap_holonomic",
                          SLALOM_HOLONOMIC("follow_the_gap_holonomic", "CHolonomicFollowTheGap")};
constexpr Shipped kField = {"potential_field",
                            SLALOM_HOLONOMIC("potential_field", "CHolonomicPotentialField")};
constexpr Shipped kMrptNd = {"CHolonomicND", "adapter = mrpt_holonomic\nclass = CHolonomicND\n"};
constexpr Shipped kMrptVff = {"CHolonomicVFF", "adapter = mrpt_holonomic\nclass = CHolonomicVFF\n"};

/// How a run ends: "success", "stuck", ...
std::string outcome(const Shipped& method, const World& world) {
  const IniFile ini = IniFile::from_text("[method.a]\n" + std::string(method.keys), "campaign.ini");
  RunSetup setup;
  const MethodContext context{ini, "method.a", setup.robot, setup.sensor};
  const bool library = std::string(method.keys).find("= library") != std::string::npos;
  const auto made = library ? make_library_method(context) : make_holonomic_method(context);
  return to_string(simulate(world, setup, 1, *made).outcome);
}

Polygon box(double x1, double y1, double x2, double y2) {
  return {{{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}}};
}

World place(const std::string& name, const std::vector<Polygon>& walls) {
  Primitives obstacles;
  obstacles.polygons = walls;
  return {Scenario::continuous(name, {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9, 4}), 0.05};
}

World empty_room() {
  return place("empty", {});
}

/// A post on the way, a little aside of the straight line.
World post() {
  Primitives obstacles;
  obstacles.discs.push_back({{4.8, 3.5}, 0.4});
  return {Scenario::continuous("post", {0, 0, 10, 8}, obstacles, {1, 4, 0}, {9, 4}), 0.05};
}

/// A pocket that is open towards the start: its bottom stands between robot and goal.
World u_trap() {
  return place("trap", {box(6, 2.8, 6.2, 5.2), box(4, 2.8, 6, 3), box(4, 5, 6, 5.2)});
}

/// A wall with a door of 1 m, for a robot 0.5 m wide.
World door() {
  return place("door", {box(5, 0, 5.2, 3.5), box(5, 4.5, 5.2, 8)});
}

TEST(Behaviour, EveryMethodDrivesToAGoalInAnEmptyRoom) {
  const World world = empty_room();
  for (const Shipped& method :
       {kGoToGoal, kDwa, kGuidedDwa, kRollout, kMppi, kVfhPlus, kSmoothNd, kNdPlus, kGap, kField})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behaviour, EveryMethodThatAvoidsGetsRoundAPost) {
  const World world = post();
  EXPECT_EQ(outcome(kGoToGoal, world), "collision");
  for (const Shipped& method :
       {kDwa, kGuidedDwa, kRollout, kMppi, kVfhPlus, kSmoothNd, kNdPlus, kGap})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behaviour, APocketTrapsWhatKnowsOnlyTheGoal) {
  // Koren and Borenstein 1991: a potential field has a local minimum there. A dynamic window and
  // blind driving do no better.
  const World world = u_trap();
  EXPECT_EQ(outcome(kGoToGoal, world), "collision");
  EXPECT_EQ(outcome(kField, world), "stuck");
  EXPECT_EQ(outcome(kDwa, world), "stuck");
}

TEST(Behaviour, ANavigationFunctionLeadsOutOfAPocket) {
  // Brock and Khatib 1999: with one on the map of what was seen there is no local minimum.
  const World world = u_trap();
  for (const Shipped& method : {kGuidedDwa, kRollout, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(Behaviour, ADoorIsBlockedForForceFieldsAndPassedByNearnessDiagrams) {
  // Koren and Borenstein 1991: no passage between closely spaced obstacles. Minguez and Montano
  // 2004: ND passes.
  const World world = door();
  EXPECT_EQ(outcome(kMrptVff, world), "stuck");
  for (const Shipped& method : {kNdPlus, kSmoothNd, kVfhPlus, kDwa, kRollout, kMppi})
    EXPECT_EQ(outcome(method, world), "success") << method.name;
}

TEST(ShippedIni, OfEachHolonomicMethodIsAccepted) {
  for (const Shipped& method : {kVfhPlus, kSmoothNd, kNdPlus, kGap, kField}) {
    const std::string name = method.name;
    const std::string config =
        "config = " SLALOM_REACTIVE_FOLDER "/" + name + "/" + name + ".ini\n";
    const IniFile ini =
        IniFile::from_text("[method.a]\n" + std::string(method.keys) + config, "campaign.ini");
    EXPECT_NO_THROW(make_holonomic_method({ini, "method.a", {}, {}})) << name;
  }
}

TEST(ShippedIni, OfEachLibraryIsAcceptedAndHoldsTheDefaults) {
  const World world = post();
  for (const Shipped& method : {kGoToGoal, kDwa, kRollout}) {
    const std::string name = method.name;
    IniFile ini = IniFile::load(SLALOM_REACTIVE_FOLDER "/" + name + "/" + name + ".ini");
    const std::string section = "method." + name;
    ini.set(section, "plugin", SLALOM_PLUGIN_FOLDER "/libslalom_" + name + ".so");
    const RunSetup setup;
    const auto with_ini = make_library_method({ini, section, setup.robot, setup.sensor});
    const IniFile bare =
        IniFile::from_text("[method.a]\n" + std::string(method.keys), "campaign.ini");
    const auto without = make_library_method({bare, "method.a", setup.robot, setup.sensor});
    const auto first = simulate(world, setup, 1, *with_ini).trajectory.samples;
    const auto second = simulate(world, setup, 1, *without).trajectory.samples;
    ASSERT_EQ(first.size(), second.size()) << name;
    EXPECT_EQ(first.back().numbers(), second.back().numbers()) << name;
  }
}

}  // namespace
}  // namespace slalom
