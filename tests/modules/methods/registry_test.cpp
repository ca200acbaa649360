#include <slalom/core/error.h>
#include <slalom/methods/registry.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

class StandStill : public Method {
 public:
  void reset(const Task&) override {}
  Command step(const Observation&) override { return {}; }
};

MethodRegistry registry_of_two() {
  MethodRegistry registry;
  registry.add("still", [](const MethodContext& context) {
    EXPECT_EQ(context.section, "method.a");
    return std::make_unique<StandStill>();
  });
  registry.add("broken", [](const MethodContext& context) -> std::unique_ptr<Method> {
    throw usage_error(context.ini.name(), "no such class");
  });
  return registry;
}

std::string error_of(const std::string& ini_text) {
  const IniFile ini = IniFile::from_text(ini_text, "campaign.ini");
  try {
    registry_of_two().create("a", {ini, "method.a", {}, {}});
  } catch (const Error& error) {
    return error.culprit() == Culprit::Usage ? error.what() : "wrong culprit";
  }
  return "no error";
}

TEST(MethodRegistry, BuildsTheMethodThatTheSectionNames) {
  const IniFile ini = IniFile::from_text("[method.a]\nadapter = still\n");
  EXPECT_NE(registry_of_two().create("a", {ini, "method.a", {}, {}}), nullptr);
}

TEST(MethodRegistry, ListsItsAdapters) {
  EXPECT_EQ(registry_of_two().adapters(), (std::vector<std::string>{"broken", "still"}));
}

TEST(MethodRegistry, NamesWhatIsMissing) {
  EXPECT_EQ(error_of("[robot]\nradius = 1\n"),
            "campaign.ini: no section for method 'a'; expected [method.a]");
  const std::string no_adapter = error_of("[method.a]\nclass = X\n");
  EXPECT_NE(no_adapter.find("campaign.ini:1"), std::string::npos) << no_adapter;
  EXPECT_NE(no_adapter.find("broken | still"), std::string::npos) << no_adapter;
  const std::string unknown = error_of("[method.a]\nadapter = lcm2\n");
  EXPECT_NE(unknown.find("campaign.ini:2"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("'lcm2'; expected one of broken, still"), std::string::npos) << unknown;
}

TEST(MethodRegistry, PassesOnWhatTheAdapterThrows) {
  EXPECT_EQ(error_of("[method.a]\nadapter = broken\n"), "campaign.ini: no such class");
}

TEST(IsValidCommand, AcceptsTheLimitsThemselvesAndTheirRounding) {
  const RobotModel robot;
  std::string why;
  EXPECT_TRUE(is_valid_command({robot.max_v, robot.max_w}, robot, why));
  EXPECT_TRUE(is_valid_command({0, -robot.max_w}, robot, why));
  EXPECT_TRUE(is_valid_command({-1e-10, robot.max_w + 1e-10}, robot, why));
  EXPECT_EQ(why, "");
}

TEST(IsValidCommand, SaysWhichSpeedIsWrong) {
  RobotModel robot;
  std::string why;
  EXPECT_FALSE(is_valid_command({1.25, 0}, robot, why));
  EXPECT_EQ(why, "v = 1.25 is outside [0, 1]");
  EXPECT_FALSE(is_valid_command({-0.5, 0}, robot, why));
  EXPECT_EQ(why, "v = -0.5 is outside [0, 1]");
  EXPECT_FALSE(is_valid_command({0, -2}, robot, why));
  EXPECT_EQ(why, "w = -2 is outside [-1.5, 1.5]");
  robot.forward_only = false;
  EXPECT_TRUE(is_valid_command({-0.5, 0}, robot, why));
}

TEST(IsValidCommand, TakesSidewaysSpeedFromHolonomicRobotsOnly) {
  RobotModel robot;
  std::string why;
  EXPECT_FALSE(is_valid_command({0, 0, 0.1}, robot, why));
  EXPECT_EQ(why, "vy = 0.1 of a differential drive is not 0");
  robot.kinematics = "holonomic";
  EXPECT_TRUE(is_valid_command({0.6, 0, -0.8}, robot, why));
  EXPECT_FALSE(is_valid_command({0.7, 0, 0.8}, robot, why));
  EXPECT_NE(why.find("speed = 1.063"), std::string::npos) << why;
}

TEST(IsValidCommand, RefusesWhatIsNoNumber) {
  std::string why;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(is_valid_command({bad, 0}, {}, why));
    EXPECT_FALSE(is_valid_command({0, bad}, {}, why));
    EXPECT_NE(why.find("not a finite number"), std::string::npos);
  }
}

}  // namespace
}  // namespace slalom
