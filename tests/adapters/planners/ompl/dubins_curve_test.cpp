// SPDX-License-Identifier: BSD-3-Clause
#include "dubins_curve.h"

#include <slalom/core/random.h>
#include <slalom/references/turning_bound.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

TPose2D random_pose(RandomEngine& engine) {
  return {uniform_real(engine, -3, 3), uniform_real(engine, -3, 3),
          uniform_real(engine, -M_PI, M_PI)};
}

void expect_end(const DubinsCurve& curve, const TPose2D& end) {
  const TPose2D last = curve.at(1);
  EXPECT_NEAR(last.x, end.x, 1e-7);
  EXPECT_NEAR(last.y, end.y, 1e-7);
  EXPECT_NEAR(mrpt::math::wrapToPi(last.phi - end.phi), 0, 1e-7);
}

TEST(DubinsCurve, EndsAtThePoseAndIsAsLongAsThatOfOmpl) {
  const auto space = std::make_shared<ompl::base::DubinsStateSpace>(0.7);
  ompl::base::ScopedState<ompl::base::SE2StateSpace> a(space), b(space);
  RandomEngine engine(1);
  for (int i = 0; i < 2000; ++i) {
    const TPose2D from = random_pose(engine), to = random_pose(engine);
    const DubinsCurve curve(from, to, 0.7);
    expect_end(curve, to);
    a->setXY(from.x, from.y);
    a->setYaw(from.phi);
    b->setXY(to.x, to.y);
    b->setYaw(to.phi);
    EXPECT_NEAR(curve.length(), space->distance(a.get(), b.get()), 1e-6) << i;
  }
}

TEST(DubinsCurve, ItsCurvatureIsThatOfTheRadius) {
  RandomEngine engine(2);
  for (int i = 0; i < 100; ++i) {
    const DubinsCurve curve(random_pose(engine), random_pose(engine), 0.7);
    constexpr int kSteps = 1000;
    for (int k = 0; k < kSteps; ++k) {
      const TPose2D p = curve.at(static_cast<double>(k) / kSteps);
      const TPose2D q = curve.at((k + 1.0) / kSteps);
      const double step = curve.length() / kSteps;
      EXPECT_LE(std::hypot(q.x - p.x, q.y - p.y), step * (1 + 1e-9));
      EXPECT_LE(std::abs(mrpt::math::wrapToPi(q.phi - p.phi)), step / 0.7 * (1 + 1e-6));
    }
  }
}

TEST(DubinsCurve, TheShortestInAnyHeadingIsTheBoundWithoutObstacles) {
  const World world(Scenario::continuous("room", {-9, -9, 9, 9}, {}, {0, 0, 0}, {1, 1}), 0.1);
  RandomEngine engine(4);
  for (int i = 0; i < 100; ++i) {
    const TPose2D to = random_pose(engine);
    const double lower = obstacle_free_bound({world, 0.25, {0, 0}, {to.x, to.y}, 0}, 0.7, false);
    double shortest = 1e9;
    for (double heading = -M_PI; heading < M_PI; heading += 0.002)
      shortest = std::min(shortest, DubinsCurve({0, 0, 0}, {to.x, to.y, heading}, 0.7).length());
    EXPECT_LE(lower, shortest * (1 + 1e-12)) << i;
    const bool is_within = std::hypot(to.x, std::abs(to.y) - 0.7) < 0.7;
    if (!is_within) {
      EXPECT_NEAR(lower, shortest, 1e-4) << to.x << " " << to.y;
    }
  }
}

TEST(DubinsCurve, AlignedPosesAreConnectedStraight) {
  for (const double error : {0.0, 1e-15, 1e-9, 1e-7, -1e-7, 3e-7, -3e-7}) {
    const TPose2D to(20, 0, error);
    const DubinsCurve curve({0, 0, -error}, to, 0.5);
    expect_end(curve, to);
    EXPECT_NEAR(curve.length(), 20, 1e-6) << error;
  }
}

}  // namespace
}  // namespace slalom
