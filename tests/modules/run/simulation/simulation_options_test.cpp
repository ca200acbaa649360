// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/simulation/simulate.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

void check(const std::string& lines) {
  const IniFile ini = IniFile::from_text("[simulation]\n" + lines, "campaign.ini");
  read_options<SimulationOptions>(ini, "simulation").check(location_in(ini, "simulation"));
}

/// Whether `lines` are refused at this line and key with these words.
::testing::AssertionResult refused(const std::string& lines, const std::string& where,
                                   std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, "campaign.ini:" + where, words, [&] { check(lines); });
}

TEST(SimulationOptions, AcceptsStepsThatDivideTheControlPeriod) {
  EXPECT_NO_THROW(check(""));
  EXPECT_NO_THROW(check("control_period = 0.1\nstep = 0.1\n"));
  EXPECT_NO_THROW(check("control_period = 0.3\nstep = 0.1\n"));
  EXPECT_NO_THROW(check("control_period = 1\nstep = 0.001\n"));
}

TEST(SimulationOptions, RefusesOtherSteps) {
  EXPECT_TRUE(refused("control_period = 0.1\nstep = 0.03\n", "3: [simulation] step: ",
                      {"0.03 s", "divide", "expected control_period (0.1 s)", "100000"}));
  EXPECT_TRUE(refused("step = 0.2\n", "2: [simulation] step: ", {"0.2"}));
  EXPECT_TRUE(refused("step = 1e-9\n", "2: [simulation] step: ", {"1e-09"}));
  EXPECT_TRUE(refused("step = 0\n", "2: [simulation] step: ", {"'0'", "> 0"}));
}

TEST(SimulationOptions, RefusesRunsWithTooManyControlPeriods) {
  EXPECT_TRUE(refused("max_time = 1e9\n", "2: [simulation] max_time: ", {"control periods"}));
}

TEST(SimulationOptions, TheTimeLimitIsTheOneGivenOrFollowsFromTheEarliestArrival) {
  SimulationOptions options;
  EXPECT_EQ(options.time_limit(), 60);
  for (const double earliest : {0.0, 1.0, 15.0, 15.5, 103.1, 2000.0})
    EXPECT_EQ(options.time_limit(earliest), earliest > 15 ? 4 * earliest : 60);
  options.time_factor = 2;
  EXPECT_EQ(options.time_limit(103), 206);
  EXPECT_EQ(options.time_limit(1e9), 0.1 * 1e6) << "a million control periods";
  options.max_time = 5;
  EXPECT_EQ(options.time_limit(103), 5);
  EXPECT_TRUE(refused("time_factor = 0.5\n", "2: [simulation] time_factor: ", {"'0.5'", ">= 1"}));
}

TEST(SimulationOptions, SuggestsTheNearestKey) {
  EXPECT_TRUE(
      refused("goal_tolerence = 1\n", "2: [simulation] goal_tolerence: ", {"'goal_tolerance'"}));
}

}  // namespace
}  // namespace slalom
