#include "mppi/mppi.h"
#include "observations.h"

#include <gtest/gtest.h>

#include <numeric>

namespace mppi {
namespace {

using namespace reactive;

/// The command after some cycles with the same observation.
Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {},
             std::uint64_t seed = 1, int cycles = 5) {
  Mppi method({}, {});
  method.reset({goal, 0.2, 0.1, seed});
  Twist twist;
  for (int i = 0; i < cycles; ++i) twist = method.step(observe(walls, goal, now));
  return twist;
}

TEST(ImportanceWeights, AreSoftMinima) {
  // exp(0), exp(-1), exp(-2) over their sum.
  const auto weights = importance_weights({3, 4, 5}, 1);
  const double sum = 1 + std::exp(-1.0) + std::exp(-2.0);
  EXPECT_NEAR(weights[0], 1 / sum, 1e-12);
  EXPECT_NEAR(weights[2], std::exp(-2.0) / sum, 1e-12);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-12);
}

TEST(ImportanceWeights, DoNotOverflowAndDoNotDependOnAConstant) {
  const auto weights = importance_weights({1e6, 1e6 + 1, 3e6}, 0.5);
  EXPECT_NEAR(weights[0], 1 / (1 + std::exp(-2.0)), 1e-12);
  EXPECT_EQ(weights[2], 0);
}

TEST(Noise, IsNormalAndFollowsItsSeed) {
  Noise noise;
  std::vector<Twist> first, again, other;
  noise.seed(5);
  noise.draw(first, 2000, 10, 1, 0.2, 0.6);
  noise.seed(5);
  noise.draw(again, 2000, 10, 1, 0.2, 0.6);
  noise.seed(6);
  noise.draw(other, 2000, 10, 1, 0.2, 0.6);
  double mean = 0, square_v = 0, square_w = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].v, again[i].v);
    mean += first[i].v / 20000;
    square_v += first[i].v * first[i].v / 20000;
    square_w += first[i].w * first[i].w / 20000;
  }
  EXPECT_NE(first[0].v, other[0].v);
  // Four standard errors: 4 * 0.2 / sqrt(20000); variances 4 * sqrt(2 / 20000) of themselves.
  EXPECT_NEAR(mean, 0, 0.0057);
  EXPECT_NEAR(square_v, 0.04, 0.04 * 0.04);
  EXPECT_NEAR(square_w, 0.36, 0.04 * 0.36);
}

TEST(Noise, IsHeldForTheGivenSteps) {
  Noise noise;
  std::vector<Twist> drawn;
  noise.seed(5);
  noise.draw(drawn, 2, 6, 4, 0.2, 0.6);
  EXPECT_EQ(drawn[0].w, drawn[3].w);
  EXPECT_NE(drawn[3].w, drawn[4].w);
  EXPECT_NE(drawn[5].w, drawn[6].w);
}

TEST(Mppi, MovesToAGoalInFreeSpace) {
  const Twist twist = decide({}, {5, 0}, {0.5, 0}, 1, 20);
  EXPECT_GT(twist.v, 0.5);
  EXPECT_LT(std::abs(twist.w), 0.3);
}

TEST(Mppi, TurnsTowardsTheOpenEndOfAWall) {
  EXPECT_GT(decide({{1.2, -4, 1.2, 0.3}}, {5, 0}, {0.3, 0}).w, 0.1);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 4}}, {5, 0}, {0.3, 0}).w, -0.1);
}

TEST(Mppi, SlowsDownBeforeAWallThatItCannotPass) {
  EXPECT_LT(decide({{0.8, -7, 0.8, 7}}, {5, 0}, {0.5, 0}, 1, 10).v, 0.3);
}

TEST(Mppi, LeavesAUShapedObstacle) {
  const Twist twist = decide({{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}}, {4, 0.2});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(std::abs(twist.w), 1);
}

TEST(Mppi, GivesTheSameCommandForTheSameSeed) {
  const std::vector<Wall> walls = {{1.2, -4, 1.2, 0.3}};
  const Twist once = decide(walls, {5, 0}, {0.3, 0}, 7), again = decide(walls, {5, 0}, {0.3, 0}, 7);
  EXPECT_EQ(once.v, again.v);
  EXPECT_EQ(once.w, again.w);
  EXPECT_NE(once.w, decide(walls, {5, 0}, {0.3, 0}, 8).w);
}

}  // namespace
}  // namespace mppi
