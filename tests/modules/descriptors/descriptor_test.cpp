#include "small_worlds.h"

#include <slalom/core/error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Density, IsTheShareOfOccupiedCells) {
  const World world = drawn_world({".....", ".#.#.", "S...G", ".#...", "....#"});
  EXPECT_DOUBLE_EQ(value_of("density", context_of(world)), 4.0 / 25);
}

TEST(Clearness, IsTheMeanDistanceOverTheRange) {
  // One row of five cells, walls all round: the distance of every centre to the wall above is half
  // a cell.
  const World world = drawn_world({"S...G"});
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 2.0)), 0.5 / 2, 1e-6);
}

TEST(Clearness, DistancesBeyondTheRangeCountAsTheRange) {
  // 5 x 5 without obstacles: 16 centres lie 0.5 m from the wall, 8 lie 1.5 m, one 2.5 m; cut at 1
  // m.
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 1.0)), (16 * 0.5 + 9 * 1.0) / 25, 1e-6);
  EXPECT_NEAR(value_of("clearness", context_of(world, 0.25, 4.0)),
              (16 * 0.5 + 8 * 1.5 + 2.5) / (4 * 25), 1e-6);
}

TEST(Confinement, IsOneWhereEveryRayMeetsSomething) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  EXPECT_DOUBLE_EQ(value_of("confinement", context_of(world, 0.25, 8)), 1);
}

TEST(Confinement, OfAnEmptyRoomIsAsIntegrated) {
  // A square of side 10 with R = 1: only places nearer than 1 to a wall see it. Of a place at
  // distance h from one wall, far from the others, the share of directions that meet it is acos(h)
  // / pi. Integrated over h in [0, 1]: 1 / pi. Four walls of 10 m in 100 m^2 give 0.4 / pi, less
  // what the corners count twice (directions that meet both walls of a corner): found here by
  // integrating a fine lattice with the slab test.
  const World world(Scenario::continuous("empty", {0, 0, 10, 10}, {}, {1, 1, 0}, {9, 9}), 0.1);
  double sum = 0;
  constexpr int kLattice = 200, kDirections = 360;
  for (int i = 0; i < kLattice; ++i)
    for (int j = 0; j < kLattice; ++j) {
      const double x = (i + 0.5) * 10 / kLattice, y = (j + 0.5) * 10 / kLattice;
      for (int k = 0; k < kDirections; ++k) {
        const double a = 2 * 3.14159265358979323846 * (k + 0.5) / kDirections;
        const double end_x = x + std::cos(a), end_y = y + std::sin(a);
        sum += end_x < 0 || end_x > 10 || end_y < 0 || end_y > 10 ? 1 : 0;
      }
    }
  const double expected = sum / (kLattice * kLattice * kDirections);
  const Value value = descriptor("confinement").compute(context_of(world, 0.25, 1.0));
  ASSERT_TRUE(value.standard_error().has_value());
  EXPECT_LE(*value.standard_error(), 0.005);
  EXPECT_NEAR(value.number(), expected, 0.015);  // three standard errors
}

Value exact_confinement_of(const World& world, double range) {
  DescriptorContext context = context_of(world, 0.25, range);
  context.exact_confinement = true;
  return descriptor("confinement").compute(context);
}

TEST(Confinement, ExactlyCountsTheArcsThatWallsFill) {
  // 1 m seen from 0.5 m away, a wall fills 2 acos(0.5 / 1) = 120 degrees. 12 cells have one wall, 4
  // have two: from 120 to 330 degrees, 210 in all. The 9 within are 1.5 m from any wall.
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  EXPECT_NEAR(exact_confinement_of(world, 1).number(), (12 * 120 + 4 * 210) / (25 * 360.0), 1e-12);
  EXPECT_FALSE(exact_confinement_of(world, 1).standard_error().has_value());
}

TEST(Confinement, ExactlyCountsWhatLiesWithinTheRangeOnly) {
  // Cells beside the block: 120 degrees of wall, and 90 of the block's face from corner to corner.
  // Cells in a corner: 210 degrees of walls; of the block what is nearer than 1 m: of each face, at
  // 0.5 m, the directions from asin(0.5) = 30 to 45 degrees, together 30 degrees.
  const World world = drawn_world({"...", "S#G", "..."});
  EXPECT_NEAR(exact_confinement_of(world, 1).number(),
              (4 * (120 + 90) + 4 * (210 + 30)) / (8 * 360.0), 1e-12);
}

TEST(Confinement, ASampleComesNearTheExactMean) {
  const World world(random_room(4, 15), 0.1);
  for (const double range : {1.0, 3.0}) {
    const Value sampled = descriptor("confinement").compute(context_of(world, 0.25, range));
    EXPECT_NEAR(sampled.number(), exact_confinement_of(world, range).number(),
                4 * *sampled.standard_error());
  }
}

TEST(Confinement, KeepsExactAndSampledValuesApart) {
  const World world = drawn_world({"S.G"});
  DescriptorContext context = context_of(world, 0.25, 2);
  EXPECT_EQ(descriptor("confinement").parameters(context), "sensor_range=2");
  context.exact_confinement = true;
  EXPECT_EQ(descriptor("confinement").parameters(context), "sensor_range=2;confinement=exact");
}

TEST(BottleneckWidth, IsTwiceTheWidestBottleneck) {
  // The opening in the middle wall is one cell, 1 m; the straight row leads through it.
  const World world = drawn_world({"..#..", "..#..", "S...G", "..#..", "..#.."});
  EXPECT_NEAR(value_of("bottleneck_width", context_of(world)), 1.0, 1e-6);
}

TEST(BottleneckWidth, IsNotAvailableWhereTheRobotDoesNotFit) {
  const World world = drawn_world({"..#..", "..#..", "S...G", "..#..", "..#.."});
  const Value value = descriptor("bottleneck_width").compute(context_of(world, 0.6));
  ASSERT_TRUE(value.is_na());
  EXPECT_EQ(value.reason(), "unsolvable: narrower than the robot");
  const World walled = drawn_world({"..#..", "..#..", "S.#.G", "..#..", "..#.."});
  EXPECT_TRUE(descriptor("bottleneck_width").compute(context_of(walled)).is_na());
}

TEST(DetourRatio, IsTheShortestLengthOverTheStraightDistance) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  // One metre up, four along, one down; the ends are 4 m apart.
  const Path path = {{0.5, 2.5}, {0.5, 3.5}, {4.5, 3.5}, {4.5, 2.5}};
  EXPECT_DOUBLE_EQ(value_of("detour_ratio", context_with_path(world, path)), 1.5);
  EXPECT_EQ(descriptor("detour_ratio").compute(context_of(world)).reason(), "not asked for here");
}

TEST(Descriptors, AWorldWithoutFreeSpaceHasNoMeans) {
  const World world = drawn_world({"###", "###", "###"});
  EXPECT_DOUBLE_EQ(value_of("density", context_of(world)), 1);
  EXPECT_EQ(descriptor("clearness").compute(context_of(world)).reason(), "no free space");
  EXPECT_EQ(descriptor("confinement").compute(context_of(world)).reason(), "no free space");
}

TEST(Descriptors, UnknownIdsAreRefusedWithTheNearest) {
  try {
    descriptor("densty");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 2);
    EXPECT_STREQ(e.what(), "descriptor: unknown id 'densty'; expected 'density'");
  }
}

}  // namespace
}  // namespace slalom
