// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/random.h>
#include <slalom/people/velocity_program.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

double violation(const std::vector<VelocityBound>& bounds, std::size_t first, std::size_t last,
                 const TPoint2D& v) {
  double worst = 0;
  for (std::size_t i = first; i < last; ++i)
    worst = std::max(worst, bounds[i].least - bounds[i].normal.x * v.x - bounds[i].normal.y * v.y);
  return worst;
}

std::vector<VelocityBound> random_bounds(RandomEngine& random, int count, double low, double high) {
  std::vector<VelocityBound> bounds;
  for (int i = 0; i < count; ++i) {
    const auto [sin, cos] = math::sin_cos(uniform_real(random, 0, 2 * M_PI));
    bounds.push_back({{cos, sin}, uniform_real(random, low, high)});
  }
  return bounds;
}

/// Calls visit(v) for velocities of a fine grid in the disc of radius 1.
template <typename Visit>
void for_each_velocity(const Visit& visit) {
  constexpr int kHalf = 100;
  for (int x = -kHalf; x <= kHalf; ++x)
    for (int y = -kHalf; y <= kHalf; ++y)
      if (x * x + y * y <= kHalf * kHalf) visit(TPoint2D(double(x) / kHalf, double(y) / kHalf));
}

TEST(VelocityProgram, FindsTheNearestVelocityOfAll) {
  RandomEngine random(7);
  for (int k = 0; k < 100; ++k) {
    // Rest keeps all bounds: there is a solution.
    const auto bounds = random_bounds(random, uniform_int(random, 0, 8), -0.5, 0);
    const TPoint2D wanted(uniform_real(random, -1.5, 1.5), uniform_real(random, -1.5, 1.5));
    const TPoint2D v = best_velocity(bounds, 0, 1, wanted);
    EXPECT_LE(v.norm(), 1 + 1e-12);
    EXPECT_LE(violation(bounds, 0, bounds.size(), v), 1e-12);
    for_each_velocity([&](const TPoint2D& other) {
      if (violation(bounds, 0, bounds.size(), other) > 0) return;
      EXPECT_GE((other - wanted).norm(), (v - wanted).norm() - 1e-12);
    });
  }
}

TEST(VelocityProgram, HasTheLeastViolationWithinTheHardBounds) {
  RandomEngine random(8);
  int infeasible = 0;
  for (int k = 0; k < 200; ++k) {
    auto bounds = random_bounds(random, 2, -0.3, 0);
    const auto soft = random_bounds(random, 6, 0, 0.8);
    bounds.insert(bounds.end(), soft.begin(), soft.end());
    const TPoint2D v = best_velocity(bounds, 2, 1, {1, 0});
    EXPECT_LE(v.norm(), 1 + 1e-12);
    EXPECT_LE(violation(bounds, 0, 2, v), 1e-12);
    const double worst = violation(bounds, 2, bounds.size(), v);
    if (worst > 1e-9) ++infeasible;
    for_each_velocity([&](const TPoint2D& other) {
      if (violation(bounds, 0, 2, other) > 0) return;
      EXPECT_GE(violation(bounds, 2, bounds.size(), other), worst - 1e-9);
    });
  }
  EXPECT_GT(infeasible, 50);
}

TEST(VelocityProgram, WalksAlongACorridorThatTouchesOnBothSides) {
  const std::vector<VelocityBound> walls = {{{0, 1}, 0}, {{0, -1}, 0}};
  const TPoint2D v = best_velocity(walls, 2, 1, {0.5, 0.5});
  EXPECT_EQ(v.x, 0.5);
  EXPECT_EQ(v.y, 0);
}

TEST(VelocityProgram, RestsWhereRoundingLeavesNothing) {
  const std::vector<VelocityBound> walls = {{{0, 1}, 1e-6}, {{0, -1}, 0}};
  const TPoint2D v = best_velocity(walls, 2, 1, {0.5, 0.5});
  EXPECT_EQ(v.x, 0);
  EXPECT_EQ(v.y, 0);
}

}  // namespace
}  // namespace slalom
