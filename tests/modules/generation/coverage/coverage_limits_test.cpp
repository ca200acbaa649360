// SPDX-License-Identifier: BSD-3-Clause
#include "coverage/coverage_limits.h"
#include "error_text.h"

#include <slalom/descriptors/descriptor.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(DensityLimit, LeavesTheSweptArea) {
  // 2 * 0.5 * 3 + pi 0.25 = 3.7854 of 100.
  EXPECT_NEAR(density_limit(0.5, 3, 10), 1 - 0.037854, 1e-6);
}

TEST(ClearnessLimit, IsThatOfADisc) {
  // In a disc of radius rho <= R the mean distance to the rim is rho / 3.
  EXPECT_NEAR(clearness_limit(M_PI * 6 * 6, 8), 6.0 / 3 / 8, 1e-12);
  // rho = 2 R: the integral of (1 - t / 2R)^2 over t / R from 0 to 1 = 2/3 (1 - 1/8).
  EXPECT_NEAR(clearness_limit(M_PI * 16 * 16, 8), 2.0 / 3 * 7 / 8, 1e-12);
  EXPECT_EQ(clearness_limit(0, 8), 0);
}

TEST(ConfinementLimit, IsOneInSmallWorkspacesAndDecreasesWithTheirSize) {
  EXPECT_NEAR(confinement_limit(9, 3, 8), 1, 1e-9);
  double before = 1;
  for (const double side : {10.0, 20.0, 50.0, 100.0, 200.0}) {
    const double limit = confinement_limit(side * side, side, 8);
    EXPECT_LT(limit, before);
    before = limit;
  }
  // The mean of cos over [0, pi/4] is 0.9003: in a wide workspace chords bound it by 0.9003 R / S.
  EXPECT_NEAR(confinement_limit(200 * 200, 200, 8), 0.9003 * 8 / 200, 1e-4);
  // Less free space means more confinement.
  EXPECT_GT(confinement_limit(1000, 200, 8), confinement_limit(2000, 200, 8));
}

/// The values of theoretically optimal scenarios satisfy the bounds, and approach them.
TEST(Limits, HoldForEmptyWorkspaces) {
  for (const double side : {6.0, 12.0, 30.0}) {
    const Scenario empty =
        Scenario::continuous("empty", {0, 0, side, side}, {}, {1, 1, 0}, {side - 1, side - 1});
    const World world(empty, 0.1);
    const DescriptorContext context{world, Footprint::disc(0.25), 8.0, {}};
    const double clearness = descriptor("clearness").compute(context).number();
    const double clear_limit = clearness_limit(side * side, 8);
    EXPECT_LT(clearness, clear_limit);
    EXPECT_GT(clearness, 0.8 * clear_limit);
    const double confinement = descriptor("confinement").compute(context).number();
    const double confined_limit = confinement_limit(side * side, side, 8);
    EXPECT_GT(confinement, confined_limit - 0.02);
    EXPECT_LT(confinement, 1.5 * confined_limit);
  }
}

TEST(InfeasibilityReason, JointBinsUseTheDensity) {
  // Clearness 0.6 requires a free disc of radius rho with 2/3 (1 - 1/8) = 0.583 at rho = 16 m: more
  // than 804 m^2. A workspace of 40 m has 1600 m^2, of which density 0.8 leaves 320.
  CoverageOptions options;
  options.max_extent = 40;
  const CoverageBins bins({{"density", {0, 0.8, 1}}, {"clearness", {0, 0.6, 1}}});
  EXPECT_FALSE(infeasibility_reason(bins, 0, options, {}));
  EXPECT_FALSE(infeasibility_reason(bins, 1, options, {}));
  EXPECT_FALSE(infeasibility_reason(bins, 2, options, {}));
  const auto reason = infeasibility_reason(bins, 3, options, {});
  ASSERT_TRUE(reason);
  EXPECT_TRUE(mentions(*reason, {"clearness", "above"}));
}

TEST(InfeasibilityReason, ChecksTheRangesOfFractionsWidthsAndDetours) {
  const CoverageOptions options;
  const auto reason = [&](const std::string& id, double low, double high) {
    return infeasibility_reason(CoverageBins({{id, {low, high}}}), 0, options, {}).value_or("");
  };
  EXPECT_TRUE(mentions(reason("density", -1, -0.5), {"density", "at least 0"}));
  EXPECT_TRUE(mentions(reason("confinement", 1.1, 2), {"confinement", "at most 1"}));
  EXPECT_TRUE(mentions(reason("bottleneck_width", 0, 0.4), {"robot", "0.5 m"}));
  EXPECT_TRUE(mentions(reason("bottleneck_width", 50, 60), {"workspace", "at most 40 m"}));
  EXPECT_TRUE(mentions(reason("detour_ratio", 0, 0.9), {"shorter", "straight line"}));
  EXPECT_EQ(reason("detour_ratio", 0.9, 1.1), "");
  EXPECT_EQ(reason("turn_density", -5, -1), "") << "no proof, no reason";
}

}  // namespace
}  // namespace slalom
