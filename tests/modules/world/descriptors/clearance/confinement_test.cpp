// SPDX-License-Identifier: BSD-3-Clause
#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Confinement, IsOneIfEveryRayHitsAnObstacle) {
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  EXPECT_DOUBLE_EQ(value_of("confinement", context_of(world, 0.25, 8)), 1);
}

TEST(Confinement, OfAnEmptyRoomEqualsTheIntegral) {
  // A square of side 10 with R = 1: only points closer than 1 to a wall see it. For a point at
  // distance h from one wall, far from the others, the fraction of directions that hit it is
  // acos(h) / pi. Integrated over h in [0, 1]: 1 / pi. Four walls of 10 m in 100 m^2 give 0.4 / pi,
  // minus the directions counted twice at corners; computed here on a fine lattice.
  const World world(Scenario::continuous("empty", {0, 0, 10, 10}, {}, {1, 1, 0}, {9, 9}), 0.1);
  double sum = 0;
  constexpr int kLattice = 200, kDirections = 360;
  for (int i = 0; i < kLattice; ++i)
    for (int j = 0; j < kLattice; ++j) {
      const double x = (i + 0.5) * 10 / kLattice, y = (j + 0.5) * 10 / kLattice;
      for (int k = 0; k < kDirections; ++k) {
        const double a = 2 * M_PI * (k + 0.5) / kDirections;
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

/// Mean confinement over the free space by brute force: marching rays from a fine lattice of
/// points.
double confinement_by_lattice(const World& world, double range) {
  constexpr int kPerCell = 24, kDirections = 720, kSteps = 200;
  const Occupancy& cells = world.occupancy();
  const auto meets = [&](double x, double y, double angle) {
    for (int k = 1; k <= kSteps; ++k) {
      const double r = range * k / kSteps;
      if (cells.occupied(static_cast<int>(std::floor(x + r * std::cos(angle))),
                         static_cast<int>(std::floor(y + r * std::sin(angle)))))
        return true;
    }
    return false;
  };
  double sum = 0, count = 0;
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (cells.occupied(cx, cy)) continue;
      for (int i = 0; i < kPerCell * kPerCell; ++i) {
        const int column = i % kPerCell, row = i / kPerCell;
        for (int d = i % 60; d < kDirections; d += 60, ++count)
          sum += meets(cx + (column + 0.5) / kPerCell, cy + (row + 0.5) / kPerCell,
                       2 * M_PI * d / kDirections);
      }
    }
  return sum / count;
}

TEST(Confinement, ExactValueIntegratesTheArcsOfWalls) {
  // Within 1 m a wall at distance y covers 2 acos(y), which integrates to 2 over 0..1 m. Strips of
  // 3 m along four walls: 24. In a corner the walls cover 2 acos(x) + 2 acos(y), less acos(x) +
  // acos(y) - pi / 2 where the corner itself is in range; with x = cos(t) the integral of
  // acos(x) sqrt(1 - x^2) is pi^2 / 16 + 1 / 4: 4 - 1 / 2 in each of four corners.
  const World world = drawn_world({".....", ".....", "S...G", ".....", "....."});
  const double expected = (24 + 4 * 3.5) / (25 * 2 * M_PI);
  EXPECT_NEAR(exact_confinement_of(world, 1).number(), expected, 2.5e-3 * expected);
  EXPECT_FALSE(exact_confinement_of(world, 1).standard_error().has_value());
}

TEST(Confinement, ExactValueIsTheMeanOverTheFreeSpaceOfLargeCells) {
  const World world = drawn_world({"..........", ".#......#.", "....#.....", "S........G",
                                   "..#...#...", "..........", "....##...."});
  for (const double range : {1.0, 2.5})
    EXPECT_NEAR(exact_confinement_of(world, range).number(), confinement_by_lattice(world, range),
                0.004)
        << range;
}

TEST(Confinement, TheSampledValueApproximatesTheExactOne) {
  const World world(random_room(4, 15), 0.1);
  for (const double range : {1.0, 3.0}) {
    const Value sampled = descriptor("confinement").compute(context_of(world, 0.25, range));
    EXPECT_NEAR(sampled.number(), exact_confinement_of(world, range).number(),
                4 * *sampled.standard_error());
  }
}

TEST(Confinement, ParametersDistinguishExactAndSampledValues) {
  const World world = drawn_world({"S.G"});
  DescriptorContext context = context_of(world, 0.25, 2);
  EXPECT_EQ(descriptor("confinement").key(context).parameters, "sensor_range=2");
  context.exact_confinement = true;
  EXPECT_EQ(descriptor("confinement").key(context).parameters,
            "sensor_range=2;confinement=integrated");
}

}  // namespace
}  // namespace slalom
