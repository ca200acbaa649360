// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/trajectory/standing.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// One sample every 0.1 s, at rest at (1, 2) from the time `stops` on, at 1 m/s along x before.
Trajectory stopping(double stops, double until) {
  Trajectory trajectory;
  for (int i = 0; 0.1 * i <= until + 1e-9; ++i) {
    Sample sample;
    sample.t = 0.1 * i;
    sample.pose = {1 + std::min(0.0, sample.t - stops), 2, 0.5};
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(HasStood, AfterHalfASecondWithoutMotion) {
  const mrpt::math::TPose2D pose(1, 2, 0.5);
  EXPECT_TRUE(has_stood(stopping(1, 1.5), 1.5, pose, false));
  EXPECT_FALSE(has_stood(stopping(1, 1.4), 1.4, pose, false));
  EXPECT_TRUE(has_stood(stopping(1, 1.4), 1.5, pose, false));  // between two samples
  EXPECT_FALSE(has_stood(stopping(1, 1.4), 1.45, pose, false));
}

TEST(HasStood, NotIfItMovedOrTurnedSinceTheLastSample) {
  const Trajectory standing = stopping(0, 2);
  EXPECT_TRUE(has_stood(standing, 2.05, {1, 2, 0.5 + 2 * M_PI}, false));
  EXPECT_FALSE(has_stood(standing, 2.05, {1.001, 2, 0.5}, false));
  EXPECT_FALSE(has_stood(standing, 2.05, {1, 2, 0.501}, false));
}

TEST(HasStood, ADiscThatRotatesInPlaceDoesNotMove) {
  Trajectory turning = stopping(0, 2);
  for (Sample& sample : turning.samples) sample.pose.phi = sample.t;
  EXPECT_TRUE(has_stood(turning, 2.05, {1, 2, 2.05}, true));
  EXPECT_FALSE(has_stood(turning, 2.05, {1, 2, 2.05}, false));
  EXPECT_FALSE(has_stood(turning, 2.05, {1.001, 2, 2.05}, true));
}

TEST(HasStood, NotInLessThanThatTime) {
  EXPECT_FALSE(has_stood({}, 1, {1, 2, 0.5}, false));
  EXPECT_FALSE(has_stood(stopping(0, 0.3), 0.4, {1, 2, 0.5}, false));
  EXPECT_TRUE(has_stood(stopping(0, 0.3), 0.5, {1, 2, 0.5}, false));
}

}  // namespace
}  // namespace slalom
