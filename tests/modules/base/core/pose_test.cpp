// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>

#include <array>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// Keeps a compiler from rounding an operation together with the next one.
double rounded(double value) {
  volatile double stored = value;
  return stored;
}

/// a b + c d of numbers that are rounded after each operation.
double sum_of_products(double a, double b, double c, double d) {
  return rounded(rounded(a * b) + rounded(c * d));
}

struct Example {
  TPose2D pose;
  TPoint2D point;
};

std::array<Example, 1000> random_examples() {
  RandomEngine engine(1);
  const auto coordinate = [&] { return uniform_real(engine, -10, 10); };
  std::array<Example, 1000> examples;
  for (Example& example : examples)
    example = {{coordinate(), coordinate(), uniform_real(engine, -M_PI, M_PI)},
               {coordinate(), coordinate()}};
  return examples;
}

TEST(Pose, FramesTurnCounterclockwise) {
  const TPose2D pose(1, 2, M_PI / 2);  // its x axis is the y axis
  const TPoint2D point = compose(pose, {3, 5});
  EXPECT_NEAR(point.x, 1 - 5, 1e-14);
  EXPECT_NEAR(point.y, 2 + 3, 1e-14);
  const TPoint2D local = inverse_compose(pose, {-4, 5});
  EXPECT_NEAR(local.x, 3, 1e-14);
  EXPECT_NEAR(local.y, 5, 1e-14);
}

TEST(Pose, EachOperationIsRoundedByItself) {
  for (const auto& [pose, point] : random_examples()) {
    const double c = math::cos(pose.phi), s = math::sin(pose.phi);
    const double dx = point.x - pose.x, dy = point.y - pose.y;
    const TPoint2D local = inverse_compose(pose, point);
    ASSERT_EQ(local.x, sum_of_products(dx, c, dy, s));
    ASSERT_EQ(local.y, sum_of_products(-dx, s, dy, c));
    const TPoint2D composed = compose(pose, point);
    ASSERT_EQ(composed.x, rounded(pose.x + rounded(point.x * c)) - rounded(point.y * s));
    ASSERT_EQ(composed.y, rounded(pose.y + rounded(point.x * s)) + rounded(point.y * c));
  }
}

TEST(Pose, AgreesWithMrptButForRounding) {
  for (const auto& [pose, point] : random_examples()) {
    const TPoint2D composed = compose(pose, point), by_mrpt = pose.composePoint(point);
    ASSERT_NEAR(composed.x, by_mrpt.x, 1e-14);
    ASSERT_NEAR(composed.y, by_mrpt.y, 1e-14);
    const TPoint2D local = inverse_compose(pose, point),
                   local_by_mrpt = pose.inverseComposePoint(point);
    ASSERT_NEAR(local.x, local_by_mrpt.x, 1e-14);
    ASSERT_NEAR(local.y, local_by_mrpt.y, 1e-14);
  }
}

}  // namespace
}  // namespace slalom
