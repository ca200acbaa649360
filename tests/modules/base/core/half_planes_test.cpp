// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/geometry.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using Points = std::vector<TPoint2D>;

const Points kSquare = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

bool is_near(const TPoint2D& a, const TPoint2D& b) {
  return (a - b).norm() < 1e-12;
}

TEST(HalfPlanes, ClipAPolygon) {
  EXPECT_EQ(clipped(kSquare, {{1, 0}, 0.5}), (Points{{0.5, -1}, {1, -1}, {1, 1}, {0.5, 1}}));
  EXPECT_EQ(clipped(kSquare, {{1, 0}, -2}), kSquare);
  EXPECT_TRUE(clipped(kSquare, {{1, 0}, 1.5}).empty());
}

TEST(HalfPlanes, KeepACornerOnTheirBorder) {
  EXPECT_EQ(clipped(kSquare, {{1, 1}, 2}), (Points{{1, 1}}));
  const Points side = clipped(kSquare, {{1, 0}, 1});
  EXPECT_EQ(side, (Points{{1, -1}, {1, 1}}));
  EXPECT_TRUE(is_near(nearest_on_border({3, 0.2}, side), {1, 0.2}));
}

TEST(HalfPlanes, TheNearestPointOfACornerAndOfAnEdge) {
  EXPECT_EQ(nearest_on_border({3, 2}, kSquare), TPoint2D(1, 1));
  EXPECT_TRUE(is_near(nearest_on_border({0.2, -4}, kSquare), {0.2, -1}));
  EXPECT_EQ(nearest_on_border({3, 2}, {{0.5, 0.5}}), TPoint2D(0.5, 0.5));
}

TEST(HalfPlanes, TheNearestPointOfTheirIntersectionIsThatOfASearch) {
  RandomEngine engine(1);
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::vector<HalfPlane> half_planes;
    Points polygon = kSquare;
    for (int i = 0; i < 6; ++i) {
      const double angle = uniform_real(engine, -M_PI, M_PI);
      half_planes.push_back({{std::cos(angle), std::sin(angle)}, -uniform_real(engine, 0.0, 0.8)});
      polygon = clipped(polygon, half_planes.back());
    }
    const TPoint2D p{uniform_real(engine, 1, 2), uniform_real(engine, 1, 2)};
    ASSERT_FALSE(polygon.empty()) << "the origin is in each of them";
    const double found = (nearest_on_border(p, polygon) - p).norm();
    // All points of a grid that are in each half plane are at least that far, one nearly that
    // close.
    constexpr double kStep = 0.02;
    double least = HUGE_VAL;
    for (double x = -1; x <= 1 + 1e-9; x += kStep)
      for (double y = -1; y <= 1 + 1e-9; y += kStep)
        if (std::all_of(half_planes.begin(), half_planes.end(), [&](const HalfPlane& h) {
              return h.excess({x, y}) >= 0;
            }))
          least = std::min(least, std::hypot(x - p.x, y - p.y));
    EXPECT_LE(found, least + 1e-9);
    EXPECT_GE(found, least - 0.15) << "thin corners may be between points of the grid";
  }
}

}  // namespace
}  // namespace slalom
