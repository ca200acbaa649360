// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"
#include "walls.h"

#include <slalom/library/library_method.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::unique_ptr<Method> load(const std::string& keys = "") {
  const IniFile ini = IniFile::from_text(
      "[method.a]\nadapter = library\nplugin = " + kFollowTheGap + "\n" + keys, "campaign.ini");
  return read_library_method(ini, "method.a")({}, {});
}

mrpt::obs::CObservation2DRangeScan scan_from(const std::vector<double>& ranges) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    scan.setScanRange(i, static_cast<float>(ranges[i]));
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

Command step(Method& method, const std::vector<double>& ranges, double goal_x, double goal_y,
             double v = 0) {
  const auto scan = scan_from(ranges);
  Observation observation;
  observation.goal_in_robot = {goal_x, goal_y};
  observation.scan = &scan;
  observation.v = v;
  return method.step(observation);
}

std::vector<double> boxed_in() {
  return follow_the_gap::scan_of(
      {{0.5, -0.5, 0.5, 0.5}, {-1, 0.5, 0.5, 0.5}, {-1, -0.5, 0.5, -0.5}});
}

TEST(FollowTheGapPlugin, GivesTheCommandOfTheAlgorithm) {
  const auto method = load();
  method->reset({});
  const auto ranges = follow_the_gap::scan_of(follow_the_gap::wall_with_opening(1.5, 1, 4));
  const std::vector<float> single(ranges.begin(), ranges.end());
  const std::vector<double> rounded(single.begin(), single.end());
  int last_side = 0;
  const auto expected = follow_the_gap::decide(rounded, 6, 0, {}, {}, last_side);
  const Command command = step(*method, ranges, 6, 0);
  EXPECT_EQ(command.v, expected.v);
  EXPECT_EQ(command.w, expected.w);
}

TEST(FollowTheGapPlugin, StopsBeforeItTurnsTowardsAGoalBehind) {
  const auto method = load();
  NavigationTask task;
  task.control_period = 0.1;
  method->reset(task);
  const auto beside = follow_the_gap::scan_of({{-1, 0.4, 3, 0.4}});
  const Command moving = step(*method, beside, -3, -0.5, 0.8);
  EXPECT_EQ(moving.v, 0);
  EXPECT_EQ(moving.w, 0);
  EXPECT_LT(step(*method, beside, -3, -0.5, 0.05).w, -1);
}

TEST(FollowTheGapPlugin, ClearsItsSideOnReset) {
  const auto method = load();
  method->reset({});
  EXPECT_LT(step(*method, boxed_in(), 5, -1).w, 0);
  EXPECT_LT(step(*method, boxed_in(), 5, 1).w, 0);
  method->reset({});
  EXPECT_GT(step(*method, boxed_in(), 5, 1).w, 0);
}

TEST(FollowTheGapPlugin, AppliesItsParameters) {
  const auto method = load("turn_gain = 0.5\n");
  method->reset({});
  // Free space, goal at 0.5 rad: w = 0.5 * 0.5.
  const Command command =
      step(*method, follow_the_gap::scan_of({}), 5 * std::cos(0.5), 5 * std::sin(0.5));
  EXPECT_NEAR(command.w, 0.25, 1e-9);
}

TEST(FollowTheGapPlugin, RefusesInvalidNumbersAndUnknownKeys) {
  const std::string where = "campaign.ini:1: [method.a]: follow_the_gap ";
  EXPECT_TRUE(throws_error(ErrorKind::Usage, where, {"margin: 'wide'", "expected a number >= 0"},
                           [] { load("margin = wide\n"); }));
  for (const std::string value : {"-1", "nan", "1x", "inf"})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, where,
                             {"alpha: '" + value + "'", "expected a number >= 0"},
                             [&] { load("alpha = " + value + "\n"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "campaign.ini:4: [method.a] margins: ",
                           {"unknown parameter", "follow_the_gap", "expected 'margin'"},
                           [] { load("margins = 1\n"); }));
}

TEST(FollowTheGapPlugin, AScanWithoutRaysIsAnError) {
  const auto method = load();
  method->reset({});
  EXPECT_THROW(step(*method, {}, 5, 0), MethodError);
}

}  // namespace
}  // namespace slalom
