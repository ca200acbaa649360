// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/distance.h>
#include <slalom/core/geometry.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

TEST(Geometry, NoPointOfASegmentIsNearerThanTheNearestOne) {
  RandomEngine engine(1);
  const auto draw = [&engine]() -> TPoint2D {
    const double x = uniform_real(engine, -1, 1);
    return {x, uniform_real(engine, -1, 1)};
  };
  constexpr int kPieces = 100;
  for (int i = 0; i < 1000; ++i) {
    const TPoint2D a = draw(), b = draw(), p = draw();
    const TPoint2D nearest = nearest_on_segment(p, a, b);
    EXPECT_NEAR(distance_between(a, nearest) + distance_between(nearest, b), distance_between(a, b),
                1e-12);
    for (int k = 0; k <= kPieces; ++k) {
      const TPoint2D other = a + (b - a) * (static_cast<double>(k) / kPieces);
      EXPECT_LE(distance_between(p, nearest), distance_between(p, other) + 1e-12);
    }
  }
}

TEST(Geometry, TheNearestPointOfASegmentWithoutLengthIsItsEnd) {
  EXPECT_EQ(nearest_on_segment({3, 4}, {1, 2}, {1, 2}), TPoint2D(1, 2));
}

TEST(Geometry, APointIsFiniteIfBothCoordinatesAre) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite({1, 2}));
  EXPECT_FALSE(is_finite({1, infinity}));
  EXPECT_FALSE(is_finite({std::numeric_limits<double>::quiet_NaN(), 2}));
}

}  // namespace
}  // namespace slalom
