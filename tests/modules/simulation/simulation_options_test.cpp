#include <slalom/core/error.h>
#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string message_of(const std::string& lines) {
  const IniFile ini = IniFile::from_text("[simulation]\n" + lines, "campaign.ini");
  try {
    read_options<SimulationOptions>(ini, "simulation").check(ini, "simulation");
  } catch (const Error& error) {
    return error.culprit() == Culprit::Usage ? error.what() : "wrong culprit";
  }
  return "";
}

TEST(SimulationOptions, AcceptsStepsThatDivideTheControlPeriod) {
  EXPECT_EQ(message_of(""), "");
  EXPECT_EQ(message_of("control_period = 0.1\nstep = 0.1\n"), "");
  EXPECT_EQ(message_of("control_period = 0.3\nstep = 0.1\n"), "");
  EXPECT_EQ(message_of("control_period = 1\nstep = 0.001\n"), "");
}

TEST(SimulationOptions, RefusesOtherSteps) {
  EXPECT_EQ(
      message_of("control_period = 0.1\nstep = 0.03\n"),
      "campaign.ini:3: [simulation] step: 0.03 s does not divide the control period; expected "
      "control_period (0.1 s) divided by a whole number up to 100000");
  EXPECT_NE(message_of("step = 0.2\n"), "");
  EXPECT_NE(message_of("step = 1e-9\n"), "");
  EXPECT_NE(message_of("step = 0\n"), "");
}

TEST(SimulationOptions, RefusesRunsThatNoMemoryHolds) {
  const std::string message = message_of("max_time = 1e9\n");
  EXPECT_NE(message.find("[simulation] max_time"), std::string::npos) << message;
}

TEST(SimulationOptions, NamesTheKeyNearestToAnUnknownOne) {
  EXPECT_NE(message_of("goal_tolerence = 1\n").find("goal_tolerance"), std::string::npos);
}

}  // namespace
}  // namespace slalom
