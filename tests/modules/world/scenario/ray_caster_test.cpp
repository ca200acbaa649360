// SPDX-License-Identifier: BSD-3-Clause
#include "random_worlds.h"

#include <slalom/scenario/ray_caster.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kFar = 1e6;

/// First t >= 0 at which the ray is in [x0, x1] x [y0, y1] (slab test), or kFar.
double slab_entry(const TPoint2D& p, double dx, double dy, double x0, double x1, double y0,
                  double y1) {
  double first = 0, last = kFar;
  const auto slab = [&](double at, double direction, double low, double high) {
    if (direction == 0) {
      if (at < low || at > high) last = -1;
      return;
    }
    const double a = (low - at) / direction, b = (high - at) / direction;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  slab(p.x, dx, x0, x1);
  slab(p.y, dy, y0, y1);
  return first <= last ? first : kFar;
}

/// Range against every occupied square and the four walls, all grown by `grow` (in cells).
double brute_force(const Occupancy& cells, const TPoint2D& origin, double angle, double grow) {
  const TPoint2D p = cells.to_cells(origin);
  const double dx = std::cos(angle), dy = std::sin(angle);
  const double sx = cells.size_x(), sy = cells.size_y();
  double nearest = std::min(std::min(slab_entry(p, dx, dy, -kFar, grow, -kFar, kFar),
                                     slab_entry(p, dx, dy, sx - grow, kFar, -kFar, kFar)),
                            std::min(slab_entry(p, dx, dy, -kFar, kFar, -kFar, grow),
                                     slab_entry(p, dx, dy, -kFar, kFar, sy - grow, kFar)));
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx)
      if (cells.occupied(cx, cy))
        nearest = std::min(
            nearest, slab_entry(p, dx, dy, cx - grow, cx + 1 + grow, cy - grow, cy + 1 + grow));
  return nearest * cells.resolution();
}

TEST(RayCaster, AgreesWithBruteForceOnAMillionRandomRays) {
  RandomEngine random(20);
  long long casts = 0;
  while (casts < 1000000) {
    const Occupancy cells = testing::random_occupancy(random, 24);
    const RayCaster caster(cells);
    for (int i = 0; i < 500; ++i, ++casts) {
      const TPoint2D origin = testing::random_point(random, cells.bounds());
      const double angle = uniform_real(random, -10, 10);
      ASSERT_NEAR(caster.cast(origin, angle, 100), brute_force(cells, origin, angle, 0), 1e-9);
    }
  }
}

/// Independent of rounding: the range lies between those for slightly smaller and slightly larger
/// squares.
TEST(RayCaster, IsBlockedByTouchedCellsAtSpecialAnglesAndOrigins) {
  RandomEngine random(21);
  for (int n = 0; n < 2000; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 12);
    const RayCaster caster(cells);
    for (int i = 0; i < 100; ++i) {
      const TPoint2D origin = cells.to_world(0.5 * uniform_int(random, 0, 2 * cells.size_x()),
                                             0.5 * uniform_int(random, 0, 2 * cells.size_y()));
      const double angles[] = {M_PI / 4 * uniform_int(random, -8, 8),
                               std::atan2(uniform_int(random, -5, 5), uniform_int(random, -5, 5))};
      for (const double angle : angles) {
        const double range = caster.cast(origin, angle, 100);
        // Touching counts: squares grown by less than the tolerance are reached no later.
        ASSERT_NEAR(range, brute_force(cells, origin, angle, 1e-10), 1e-8)
            << cells.to_cells(origin).x << ' ' << cells.to_cells(origin).y << ' ' << angle;
      }
    }
  }
}

Occupancy empty_square(int size) {
  return {size, size, 1.0, {0, 0}};
}

TEST(RayCaster, IsStoppedByTwoCellsThatMeetAtACorner) {
  Occupancy cells = empty_square(6);
  cells.set_occupied(2, 3, true);
  cells.set_occupied(3, 2, true);
  const RayCaster caster(cells);
  EXPECT_NEAR(caster.cast({1, 1}, M_PI / 4, 100), 2 * M_SQRT2, 1e-9);
  EXPECT_NEAR(caster.cast({5, 5}, -3 * M_PI / 4, 100), 2 * M_SQRT2, 1e-9);
  for (double aside = -1e-7; aside < 1e-7; aside += 1e-9)
    EXPECT_NEAR(caster.cast({1 + aside, 1}, M_PI / 4, 100), 2 * M_SQRT2, 1e-6);
}

TEST(RayCaster, IsStoppedByACornerThatItTouches) {
  Occupancy cells = empty_square(6);
  cells.set_occupied(3, 2, true);
  EXPECT_NEAR(RayCaster(cells).cast({1, 1}, M_PI / 4, 100), 2 * M_SQRT2, 1e-9);
  EXPECT_NEAR(RayCaster(cells).cast({1, 1.01}, M_PI / 4, 100), 4.99 * M_SQRT2 - 0, 2e-2);
}

TEST(RayCaster, IsStoppedByACellWhoseBorderItFollows) {
  Occupancy cells = empty_square(6);
  cells.set_occupied(3, 2, true);
  const RayCaster caster(cells);
  EXPECT_DOUBLE_EQ(caster.cast({0.5, 3}, 0, 100), 2.5);
  EXPECT_DOUBLE_EQ(caster.cast({0.5, 2}, 0, 100), 2.5);
  EXPECT_DOUBLE_EQ(caster.cast({5.5, 3}, M_PI, 100), 1.5);
  EXPECT_DOUBLE_EQ(caster.cast({4, 0.5}, M_PI / 2, 100), 1.5);
  EXPECT_DOUBLE_EQ(caster.cast({3, 5.5}, -M_PI / 2, 100), 2.5);
  EXPECT_DOUBLE_EQ(caster.cast({0.5, 4}, 0, 100), 5.5) << "a row further up it is free";
}

TEST(RayCaster, IsZeroFromOriginsThatAreNotFree) {
  Occupancy cells = empty_square(6);
  cells.set_occupied(3, 2, true);
  const RayCaster caster(cells);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const TPoint2D& origin :
       {TPoint2D(3.5, 2.5), TPoint2D(3, 2), TPoint2D(3, 2.5), TPoint2D(0, 3), TPoint2D(6, 6),
        TPoint2D(-1, 3), TPoint2D(1e300, 3), TPoint2D(nan, 3), TPoint2D(3, infinity)})
    for (const double angle : {0.0, 0.3, 2.0, -3.0})
      EXPECT_EQ(caster.cast(origin, angle, 100), 0) << origin.x << ' ' << origin.y;
  EXPECT_EQ(caster.cast({1, 1}, nan, 100), 0);
}

TEST(RayCaster, EndsAtTheMaximumRange) {
  const RayCaster caster(empty_square(6));
  EXPECT_DOUBLE_EQ(caster.cast({1, 1}, 0.3, 2), 2);
  EXPECT_DOUBLE_EQ(caster.cast({1, 1}, 0, 2), 2);
  EXPECT_DOUBLE_EQ(caster.cast({1, 1}, M_PI, 2), 1) << "the wall is nearer";
}

TEST(RayCaster, IsInvariantUnderReflection) {
  RandomEngine random(22);
  for (int n = 0; n < 300; ++n) {
    const Occupancy cells = testing::random_occupancy(random, 20);
    Occupancy mirrored(cells.size_x(), cells.size_y(), cells.resolution(), cells.origin());
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx)
        mirrored.set_occupied(cells.size_x() - 1 - cx, cy, cells.occupied(cx, cy));
    const RayCaster caster(cells), mirror(mirrored);
    for (int i = 0; i < 200; ++i) {
      const TPoint2D at(0.5 * uniform_int(random, 0, 2 * cells.size_x()),
                        0.5 * uniform_int(random, 0, 2 * cells.size_y()));
      const double angle = M_PI / 12 * uniform_int(random, -12, 12);
      EXPECT_NEAR(caster.cast(cells.to_world(at.x, at.y), angle, 100),
                  mirror.cast(cells.to_world(cells.size_x() - at.x, at.y), M_PI - angle, 100),
                  1e-9);
    }
  }
}

TEST(ScanGeometry, SpreadsRaysOverTheApertureIncludingBothEnds) {
  const ScanGeometry geometry;
  EXPECT_DOUBLE_EQ(geometry.angle(0), -M_PI / 2);
  EXPECT_DOUBLE_EQ(geometry.angle(90), 0);
  EXPECT_DOUBLE_EQ(geometry.angle(180), M_PI / 2);
  EXPECT_EQ((ScanGeometry{1, 2.0, 8.0}).angle(0), 0);
}

}  // namespace
}  // namespace slalom
