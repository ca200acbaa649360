// SPDX-License-Identifier: BSD-3-Clause
#include "random_worlds.h"

#include <slalom/scenario/geometry.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

const Polygon kSquare{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
const Polygon kArrow{{{0, 0}, {4, 0}, {4, 4}, {2, 1}}};  // not convex at (2, 1)

/// Whether p lies inside, from the winding angle of the border around p (invalid for p on the
/// border).
bool winds_around(const Polygon& polygon, const TPoint2D& p) {
  double angle = 0;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const TPoint2D a = v[i] - p, b = v[(i + 1) % v.size()] - p;
    angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return std::abs(angle) > M_PI;
}

TEST(Geometry, MeasuresTheDistanceToADiscFromItsRim) {
  const Disc disc{{1, 2}, 0.5};
  EXPECT_DOUBLE_EQ(distance({4, 6}, disc), 4.5);  // 3-4-5 triangle
  EXPECT_EQ(distance({1.2, 2.1}, disc), 0);
  EXPECT_EQ(distance({1.5, 2}, disc), 0);
}

TEST(Geometry, MeasuresTheDistanceToASegmentFromItsNearestPoint) {
  EXPECT_DOUBLE_EQ(distance_to_segment({1, 3}, {0, 0}, {4, 0}), 3);
  EXPECT_DOUBLE_EQ(distance_to_segment({-3, 4}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({7, -4}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

TEST(Geometry, MeasuresTheDistanceToAPolygon) {
  EXPECT_DOUBLE_EQ(distance({3, 1}, kSquare), 1);
  EXPECT_DOUBLE_EQ(distance({5, 6}, kSquare), 5);
  EXPECT_EQ(distance({1, 1}, kSquare), 0);
  // Nearest point of the edge from (4, 4) to (2, 1), whose unit normal is (3, -2) / sqrt 13.
  EXPECT_DOUBLE_EQ(distance({2, 2}, kArrow), 2 / std::sqrt(13.0));
}

TEST(Geometry, CountsTheBorderOfAPolygonAsInside) {
  EXPECT_TRUE(contains(kArrow, {2, 1}));
  EXPECT_TRUE(contains(kArrow, {4, 4}));
  EXPECT_TRUE(contains(kArrow, {4, 2}));
  EXPECT_TRUE(contains(kArrow, {1, 0.5}));
  EXPECT_TRUE(contains(kArrow, {3, 1}));
  EXPECT_FALSE(contains(kArrow, {2, 1.01}));
  EXPECT_FALSE(contains(kArrow, {-1, 0}));
}

TEST(Geometry, AgreesWithTheWindingAngleAboutWhatIsInside) {
  RandomEngine random(1);
  for (int n = 0; n < 500; ++n) {
    const Polygon polygon = testing::random_star(random, {0, 0}, 2);
    for (int i = 0; i < 100; ++i) {
      const TPoint2D p = testing::random_point(random, {-2, -2, 2, 2});
      EXPECT_EQ(contains(polygon, p), winds_around(polygon, p));
    }
  }
}

TEST(Geometry, SignsThePolygonsAreaByItsOrientation) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 4);
  EXPECT_DOUBLE_EQ(signed_area({{{0, 2}, {2, 2}, {2, 0}, {0, 0}}}), -4);
  // The triangle below the diagonal (8) without the one between it and (2, 1): 8 - |4 1 - 4 2| / 2.
  EXPECT_DOUBLE_EQ(signed_area(kArrow), 6);
}

TEST(Geometry, DetectsSimplePolygons) {
  EXPECT_TRUE(is_simple(kSquare));
  EXPECT_TRUE(is_simple(kArrow));
  EXPECT_TRUE(is_simple({{{0, 0}, {1, 0}, {2, 0}, {2, 2}}}))
      << "a vertex on a straight edge is allowed";
  EXPECT_FALSE(is_simple({{{0, 0}, {1, 0}}}));
  EXPECT_FALSE(is_simple({{{0, 0}, {1, 0}, {2, 0}}})) << "no area";
  EXPECT_FALSE(is_simple({{{0, 0}, {2, 2}, {2, 0}, {0, 3}}})) << "edges cross";
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 0}, {2, 0}, {2, 2}}})) << "an edge turns back";
  EXPECT_FALSE(is_simple({{{0, 0}, {0, 0}, {2, 0}, {2, 2}}})) << "a vertex twice";
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}})) << "a vertex touches an edge";
}

TEST(Geometry, CastsRaysOntoSimpleObstacles) {
  const Bounds bounds{-10, -10, 10, 10};
  EXPECT_DOUBLE_EQ(cast_ray({{{{5, 0}, 1}}, {}}, bounds, {0, 0}, 0, 20), 4);
  EXPECT_DOUBLE_EQ(cast_ray({{{{5, 0}, 1}}, {}}, bounds, {0, 0}, M_PI, 20), 10) << "the wall";
  EXPECT_DOUBLE_EQ(cast_ray({{{{5, 0}, 1}}, {}}, bounds, {0, 0}, 0, 3), 3) << "the largest range";
  EXPECT_NEAR(cast_ray({{{{5, 1}, 1}}, {}}, bounds, {0, 0}, 0, 20), 5, 1e-6) << "touches";
  EXPECT_EQ(cast_ray({{{{5, 0}, 1}}, {}}, bounds, {5.5, 0}, 0, 20), 0) << "from inside";
  EXPECT_DOUBLE_EQ(cast_ray({{}, {kSquare}}, bounds, {-3, 1}, 0, 20), 3);
  EXPECT_DOUBLE_EQ(cast_ray({{}, {kSquare}}, bounds, {-3, 0}, 0, 20), 3) << "along an edge";
  EXPECT_DOUBLE_EQ(cast_ray({{}, {kSquare}}, bounds, {-3, 2}, 0, 20), 3) << "along an edge";
  EXPECT_DOUBLE_EQ(cast_ray({{}, {kSquare}}, bounds, {-3, -3}, M_PI / 4, 20), 3 * M_SQRT2);
  EXPECT_EQ(cast_ray({}, bounds, {11, 0}, M_PI, 20), 0) << "from outside";
}

/// Sphere tracing: no step is longer than the distance to the nearest obstacle or border. Ends at a
/// point closer than `near` to one of them.
double march(const Primitives& obstacles, const Bounds& bounds, const TPoint2D& origin,
             double angle, double near) {
  double t = 0;
  for (;;) {
    const TPoint2D p(origin.x + t * std::cos(angle), origin.y + t * std::sin(angle));
    double step = std::min(std::min(p.x - bounds.x_min, bounds.x_max - p.x),
                           std::min(p.y - bounds.y_min, bounds.y_max - p.y));
    for (const Disc& disc : obstacles.discs) step = std::min(step, distance(p, disc));
    for (const Polygon& polygon : obstacles.polygons) step = std::min(step, distance(p, polygon));
    if (step < near) return t;
    t += step;
  }
}

TEST(Geometry, AgreesWithSphereTracing) {
  RandomEngine random(2);
  const double near = 1e-7;
  int casts = 0;
  while (casts < 20000) {
    const Bounds bounds{0, 0, 4, 3};
    const Primitives obstacles = testing::random_primitives(random, bounds, 4);
    for (int i = 0; i < 50; ++i, ++casts) {
      const TPoint2D origin = testing::random_point(random, bounds);
      const double angle = uniform_real(random, -7, 7);
      const double range = cast_ray(obstacles, bounds, origin, angle, 100);
      const double marched = march(obstacles, bounds, origin, angle, near);
      ASSERT_LE(marched, range + near);
      if (marched < range - 1e-3) {  // it stopped at an obstacle that the ray passes closely
        ASSERT_LT(march(obstacles, bounds, origin, angle, near / 1000), range + near);
        continue;
      }
      ASSERT_NEAR(marched, range, 1e-3);
    }
  }
}

/// The range by an independent solution in long double: discs by the angle at the origin of the
/// ray, edges by Cramer's rule.
double cast_by_solving(const Primitives& obstacles, const Bounds& bounds, const TPoint2D& origin,
                       double angle) {
  using Real = long double;
  const Real dx = std::cos(angle), dy = std::sin(angle);
  Real nearest = 1e9L;
  const auto hit = [&](Real t) {
    if (t >= 0) nearest = std::min(nearest, t);
  };
  const auto edge = [&](const TPoint2D& a, const TPoint2D& b) {
    const Real ex = Real(b.x) - a.x, ey = Real(b.y) - a.y;
    const Real ax = Real(a.x) - origin.x, ay = Real(a.y) - origin.y;
    const Real det = ex * dy - ey * dx;
    const Real fraction = (ay * dx - ax * dy) / det;
    if (fraction >= 0 && fraction <= 1) hit((ex * ay - ey * ax) / det);
  };
  for (const Disc& disc : obstacles.discs) {
    const Real fx = Real(disc.center.x) - origin.x, fy = Real(disc.center.y) - origin.y;
    if (std::hypot(fx, fy) <= disc.radius) return 0;
    const Real bearing = std::atan2(fy, fx) - std::atan2(dy, dx);
    const Real sine = std::hypot(fx, fy) * std::sin(bearing) / disc.radius;
    if (std::abs(sine) > 1 || std::cos(bearing) < 0) continue;
    hit(std::hypot(fx, fy) * std::cos(bearing) - disc.radius * std::sqrt(1 - sine * sine));
  }
  for (const Polygon& polygon : obstacles.polygons) {
    if (winds_around(polygon, origin)) return 0;
    const auto& v = polygon.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) edge(v[i], v[(i + 1) % v.size()]);
  }
  const TPoint2D corners[] = {{bounds.x_min, bounds.y_min},
                              {bounds.x_max, bounds.y_min},
                              {bounds.x_max, bounds.y_max},
                              {bounds.x_min, bounds.y_max}};
  for (int i = 0; i < 4; ++i) edge(corners[i], corners[(i + 1) % 4]);
  return static_cast<double>(nearest);
}

TEST(Geometry, AgreesWithAnIndependentSolutionOnAMillionRays) {
  RandomEngine random(3);
  int casts = 0;
  while (casts < 1000000) {
    const Bounds bounds{-1, 2, 3, 5};
    const Primitives obstacles = testing::random_primitives(random, bounds, 2);
    for (int i = 0; i < 400; ++i, ++casts) {
      const TPoint2D origin = testing::random_point(random, bounds);
      const double angle = uniform_real(random, -7, 7);
      ASSERT_NEAR(cast_ray(obstacles, bounds, origin, angle, 100),
                  cast_by_solving(obstacles, bounds, origin, angle), 1e-6);
    }
  }
}

}  // namespace
}  // namespace slalom
