#include "coverage_limits.h"

#include <slalom/descriptors/descriptor.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(DensityLimit, LeavesTheSweptDisc) {
  // 2 * 0.5 * 3 + pi 0.25 = 3.7854 of 100.
  EXPECT_NEAR(density_limit(0.5, 3, 10), 1 - 0.037854, 1e-6);
}

TEST(ClearnessLimit, IsThatOfADisc) {
  // In a disc of radius rho <= R the mean distance to the rim is rho / 3.
  EXPECT_NEAR(clearness_limit(kPi * 6 * 6, 8), 6.0 / 3 / 8, 1e-12);
  // rho = 2 R: the integral of (1 - t / 2R)^2 over t / R from 0 to 1 = 2/3 (1 - 1/8).
  EXPECT_NEAR(clearness_limit(kPi * 16 * 16, 8), 2.0 / 3 * 7 / 8, 1e-12);
  EXPECT_EQ(clearness_limit(0, 8), 0);
}

TEST(ConfinementLimit, IsOneWhereNoRayIsLongEnoughAndFallsWithTheFloor) {
  EXPECT_NEAR(confinement_limit(9, 3, 8), 1, 1e-9);
  double before = 1;
  for (const double side : {10.0, 20.0, 50.0, 100.0, 200.0}) {
    const double limit = confinement_limit(side * side, side, 8);
    EXPECT_LT(limit, before);
    before = limit;
  }
  // The mean of cos over [0, pi/4] is 0.9003: on a wide floor chords bound it by 0.9003 R / S.
  EXPECT_NEAR(confinement_limit(200 * 200, 200, 8), 0.9003 * 8 / 200, 1e-4);
  // Less free space, more confinement.
  EXPECT_GT(confinement_limit(1000, 200, 8), confinement_limit(2000, 200, 8));
}

/// The true values of what is best in theory keep the bounds, and come near.
TEST(Limits, HoldForEmptyFloorsAndRoundRooms) {
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

TEST(WhyImpossible, JointBinsUseTheDensity) {
  // Clearness 0.6 takes a free disc of radius rho with 2/3 (1 - 1/8) = 0.583 at rho = 16 m: more
  // than 804 m^2. A floor of 40 m has 1600 m^2, of which density 0.8 leaves 320.
  CoverageOptions options;
  options.max_floor = 40;
  const CoverageBins bins({{"density", {0, 0.8, 1}}, {"clearness", {0, 0.6, 1}}});
  EXPECT_FALSE(why_impossible(bins, 0, options, {}));
  EXPECT_FALSE(why_impossible(bins, 1, options, {}));
  EXPECT_FALSE(why_impossible(bins, 2, options, {}));
  const auto why = why_impossible(bins, 3, options, {});
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("clearness above"), std::string::npos) << *why;
}

TEST(WhyImpossible, SharesWidthsAndDetoursHaveTheirRanges) {
  const CoverageOptions options;
  const auto why = [&](const std::string& id, double low, double high) {
    return why_impossible(CoverageBins({{id, {low, high}}}), 0, options, {}).value_or("");
  };
  EXPECT_EQ(why("density", -1, -0.5), "density is a share, at least 0");
  EXPECT_EQ(why("confinement", 1.1, 2), "confinement is a share, at most 1");
  EXPECT_EQ(why("bottleneck_width", 0, 0.4), "the robot is 0.5 m wide");
  EXPECT_EQ(why("bottleneck_width", 50, 60), "the floor is at most 40 m wide");
  EXPECT_EQ(why("detour_ratio", 0, 0.9), "no path is shorter than the straight line");
  EXPECT_EQ(why("detour_ratio", 0.9, 1.1), "");
  EXPECT_EQ(why("turn_density", -5, -1), "") << "nothing is proved, nothing is said";
}

}  // namespace
}  // namespace slalom
