// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/trajectory/path.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

const Path kElbow = {{0, 0}, {3, 0}, {3, 4}};

TEST(Path, LengthIsTheSumOfItsSegments) {
  EXPECT_EQ(length(kElbow), 7);
  EXPECT_EQ(length({}), 0);
  EXPECT_EQ(length({{1, 1}}), 0);
}

TEST(Path, DistanceIsToTheNearestPointOfAnySegment) {
  EXPECT_EQ(distance_to_path({1, 2}, kElbow), 2);    // above the first segment, 2 from the second
  EXPECT_EQ(distance_to_path({3, 2}, kElbow), 0);    // on it
  EXPECT_EQ(distance_to_path({6, 8}, kElbow), 5);    // beyond its end: 3-4-5
  EXPECT_EQ(distance_to_path({4, 5}, {{1, 1}}), 5);  // a path of one point
  EXPECT_EQ(distance_to_path({0, 1}, {{0, 0}, {0, 0}}), 1);  // a segment of zero length
  EXPECT_THROW(distance_to_path({0, 0}, {}), std::invalid_argument);
}

TEST(Path, DistanceAgreesWithDenseSampling) {
  RandomEngine engine(1);
  const auto point = [&] {
    return mrpt::math::TPoint2D(uniform_real(engine, 0, 5), uniform_real(engine, 0, 5));
  };
  for (int trial = 0; trial < 50; ++trial) {
    const Path path = {point(), point(), point(), point()};
    const mrpt::math::TPoint2D p = point();
    double nearest = 1e9;
    for (const auto& q : resample(path, 1e-3))
      nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
    EXPECT_NEAR(distance_to_path(p, path), nearest, 1e-3);
    EXPECT_LE(distance_to_path(p, path), nearest + 1e-12);
  }
}

TEST(Path, ResamplingKeepsVerticesLengthAndSpacing) {
  const Path points = resample(kElbow, 0.7);
  EXPECT_NEAR(length(points), 7, 1e-12);
  // 3 m in 5 pieces of 0.6 m and 4 m in 6 of 0.667 m: 12 points.
  ASSERT_EQ(points.size(), 12U);
  EXPECT_EQ(points[5].x, 3);
  EXPECT_EQ(points[5].y, 0);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LE(length({points[i - 1], points[i]}), 0.7 + 1e-12);
  EXPECT_THROW(resample(kElbow, 0), std::invalid_argument);
}

}  // namespace
}  // namespace slalom
