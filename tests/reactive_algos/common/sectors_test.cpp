// SPDX-License-Identifier: BSD-3-Clause
#include "common/sectors.h"
#include "common/valleys.h"
#include "holonomic_scenes.h"

#include <gtest/gtest.h>

namespace reactive {
namespace {

TEST(Sectors, StartBehindOnTheRight) {
  const Sectors sectors = sectors_with({});
  EXPECT_NEAR(sectors.direction(0), -178.5 * kDegree, 1e-12);
  EXPECT_EQ(sectors.sector_of(-178.5 * kDegree), 0U);
  EXPECT_EQ(sectors.sector_of(0.1 * kDegree), 60U);
  EXPECT_EQ(sectors.sector_of(M_PI), 119U);
  EXPECT_EQ(sectors.sector_of(3 * M_PI + 0.1), 1U);  // 5.7 degrees beyond pi
}

TEST(OpenRuns, ContinueAcrossTheEndOfTheCircle) {
  // Blocked ahead from -60 to 60 degrees: one run of 240 degrees behind the robot.
  const auto runs = open_runs(sectors_with({{-60, 60, 0.1}}), 0.5);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].length, 80U);
  const Opening opening = opening_of(sectors_with({}), runs[0]);
  EXPECT_NEAR(opening.low, 60 * kDegree, 1e-9);
  EXPECT_NEAR(opening.high(), -60 * kDegree, 1e-9);
  EXPECT_NEAR(std::abs(opening.middle()), M_PI, 1e-9);
}

TEST(OpenRuns, CoverTheFullCircleOrNothing) {
  EXPECT_EQ(open_runs(sectors_with({}), 0.5).at(0).length, kSectors);
  EXPECT_TRUE(open_runs(sectors_with({{-181, 181, 0.1}}), 0.5).empty());
}

TEST(Opening, NearestDirectionIsInside) {
  const Opening opening{10 * kDegree, 60 * kDegree};
  EXPECT_NEAR(opening.nearest_to(30 * kDegree, 0), 30 * kDegree, 1e-12);
  EXPECT_NEAR(opening.nearest_to(-90 * kDegree, 0), 10 * kDegree, 1e-12);
  EXPECT_NEAR(opening.nearest_to(-90 * kDegree, 20 * kDegree), 30 * kDegree, 1e-12);
  EXPECT_NEAR(opening.nearest_to(-90 * kDegree, 50 * kDegree), 40 * kDegree, 1e-12);
  EXPECT_TRUE(opening.contains(69 * kDegree));
  EXPECT_FALSE(opening.contains(71 * kDegree));
}

TEST(FindValleys, LieBetweenRisingGaps) {
  // A close obstacle ahead; the rest is one valley with two rising ends.
  const auto valleys = find_valleys(sectors_with({{-30, 30, 0.2}}), 0.2, 0.05);
  ASSERT_EQ(valleys.size(), 1U);
  EXPECT_TRUE(valleys[0].rises_low && valleys[0].rises_high);
  EXPECT_NEAR(valleys[0].span.low, 30 * kDegree, 1e-9);
  EXPECT_NEAR(valleys[0].span.width, 300 * kDegree, 1e-9);
}

TEST(FindValleys, AStepIsAValleyWithOneRisingEnd) {
  // 0.2 on the right, 0.6 on the left, otherwise free.
  const auto valleys = find_valleys(sectors_with({{-90, 0, 0.2}, {0, 90, 0.6}}), 0.2, 0.05);
  ASSERT_EQ(valleys.size(), 2U);
  for (const Valley& valley : valleys) {
    if (!valley.span.contains(45 * kDegree)) continue;
    EXPECT_TRUE(valley.rises_low);
    EXPECT_FALSE(valley.rises_high);
  }
}

TEST(FindValleys, EndAtTheBorderOfTheFieldOfViewOnlyWithADiscontinuity) {
  // A wall seen up to 90 degrees on both sides; free from -30 to 10 degrees.
  const auto ahead = [](double wall) {
    return sectors_with({{10, 180, wall}, {-180, -30, wall}}).ahead(M_PI);
  };
  const auto valleys = find_valleys(ahead(0.34), 0.2, 0.15);
  ASSERT_EQ(valleys.size(), 1U);
  EXPECT_NEAR(valleys[0].span.low, -30 * kDegree, 1e-9);
  EXPECT_NEAR(valleys[0].span.high(), 9 * kDegree, 1e-9);
  EXPECT_EQ(find_valleys(ahead(0.36), 0.2, 0.15).size(), 3U);
  // A border at which nothing is seen may lead around.
  EXPECT_EQ(find_valleys(sectors_with({{-180, 60, 0.34}}).ahead(M_PI), 0.2, 0.15).size(), 1U);
}

TEST(ChooseValley, SelectsTheOneClosestToTheTarget) {
  const Sectors sectors = sectors_with({{-30, 30, 0.2}, {60, 180, 0.2}, {-180, -120, 0.2}});
  const auto valleys = find_valleys(sectors, 0.2, 0.05);
  ASSERT_EQ(valleys.size(), 2U);
  const Choice left = choose_valley(valleys, sectors, target_at(10), 1);
  EXPECT_TRUE(left.valley->span.contains(45 * kDegree));
  EXPECT_TRUE(left.low_end);
  EXPECT_FALSE(left.contains_target);
  EXPECT_TRUE(choose_valley(valleys, sectors, target_at(-50), 1).contains_target);
  EXPECT_EQ(choose_valley({}, sectors, target_at(0), 1).valley, nullptr);
}

}  // namespace
}  // namespace reactive
