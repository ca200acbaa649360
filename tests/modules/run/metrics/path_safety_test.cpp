// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(Safety, IsOneOnTheSafestPath) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {8, 5}}).number("safety"), 1, 1e-12);
}

TEST(Safety, ComparesTheClearanceOfTheFootprint) {
  // Along y = 2 the center is 2 m from the wall, along the safest path, y = 5, it is 5 m.
  const double r = 0.25;
  EXPECT_NEAR(MeasuredRun({{2, 2}, {8, 2}}).number("safety"), (2 - r) / (5 - r), 1e-9);
}

TEST(Safety, WeighsByLengthNotBySamples) {
  // Up from y = 1 to y = 3: mean distance 2 m, independent of the time at its ends.
  const double expected = (2 - 0.25) / (5 - 0.25);
  EXPECT_NEAR(MeasuredRun({{4, 1}, {4, 3}}).number("safety"), expected, 1e-9);
  EXPECT_NEAR(MeasuredRun({{4, 1}, {4, 1}, {4, 1}, {4, 1.1}, {4, 3}}).number("safety"), expected,
              1e-9);
}

TEST(Safety, IsNaIfTheSafestPathHasNoClearance) {
  MeasuredRun run({{2, 2}, {8, 2}});
  run.set_safest({{2, 0.25}, {8, 0.25}});
  EXPECT_EQ(run.reason("safety"), "the safest path has no clearance");
}

TEST(Safety, IsNaForAPathOfZeroLength) {
  EXPECT_EQ(MeasuredRun({{8, 5}}).reason("safety"), "a path of zero length has no mean clearance");
}

TEST(SafetyArea, IsTheAreaToTheSafestPathPerItsLength) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {8, 5}}).number("safety_area"), 0, 1e-12);
  // 6 m traveled at 1 m from a path of 6 m.
  EXPECT_NEAR(MeasuredRun({{2, 4}, {8, 4}}).number("safety_area"), 1, 1e-9);
  // A safest path twice as long, on the same line: half of that.
  MeasuredRun run({{2, 4}, {8, 4}});
  run.set_safest({{-1, 5}, {11, 5}});
  EXPECT_NEAR(run.number("safety_area"), 0.5, 1e-9);
}

}  // namespace
}  // namespace slalom::testing
