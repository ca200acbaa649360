// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

TEST(OptiSafe, IsOneOnAShortestAndSafestPath) {
  EXPECT_NEAR(MeasuredRun({{2, 5}, {8, 5}}).number("optisafe"), 1, 1e-12);
}

TEST(OptiSafe, FollowsItsFormula) {
  // Down to y = 2 and up again: L = 2 sqrt(3^2 + 3^2), o = 2 - L/6; the minimum clearance is 2 m
  // minus the radius, on the safest path 5 m minus the radius.
  const double o = 2 - 2 * std::sqrt(18) / 6, s = (2 - 0.25) / (5 - 0.25);
  EXPECT_NEAR(MeasuredRun({{2, 5}, {5, 2}, {8, 5}}).number("optisafe"),
              (1 - std::abs(o - s)) * std::hypot(o, s) / std::sqrt(2), 1e-9);
}

TEST(OptiSafe, IsReducedIfOneComponentIsZero) {
  // A straight line up to a contact with the wall: s = 0. |o - s| = o.
  const MeasuredRun run({{2, 5}, {5, 0.25}, {8, 5}});
  const double o = 1 - (2 * std::hypot(3, 4.75) - 6) / 6;
  EXPECT_NEAR(run.number("optisafe"), (1 - o) * o / std::sqrt(2), 1e-9);
}

TEST(OptiSafe, IsNaIfTheSafestPathHasNoClearance) {
  MeasuredRun run({{2, 5}, {8, 5}});
  run.set_safest({{2, 0.25}, {8, 0.25}});
  EXPECT_EQ(run.reason("optisafe"), "the safest path has no clearance");
}

}  // namespace
}  // namespace slalom::testing
