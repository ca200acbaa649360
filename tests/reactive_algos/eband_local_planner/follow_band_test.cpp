// SPDX-License-Identifier: BSD-3-Clause
#include "eband_local_planner/follow_band.h"

#include <gtest/gtest.h>

namespace eband_local_planner {
namespace {

using namespace reactive;

/// Parameters for a robot of 0.5 m/s and 1 rad/s.
ControllerParameters parameters() {
  ControllerParameters result;
  result.max_vel_lin = 0.5;
  result.max_vel_th = 1;
  return result;
}

/// A bubble of the robot at the origin and one 0.6 m from it, by its bearing.
std::vector<Bubble> band_of(double bearing, double robot_radius = 0.5, double next_radius = 0.5) {
  return {{{0, 0}, robot_radius},
          {{0.6 * std::cos(bearing), 0.6 * std::sin(bearing)}, next_radius}};
}

TEST(FollowBand, IsAsFastAsTheBubbleIsLarge) {
  ControllerParameters p = parameters();
  // 2 / m * 0.7 * radius * 0.5 m/s, between 0.1 and 0.5 m/s.
  EXPECT_NEAR(follow(band_of(0, 0.4), {}, p).v, 0.28, 1e-12);
  EXPECT_NEAR(follow(band_of(0, 0.2), {}, p).v, 0.14, 1e-12);
  EXPECT_EQ(follow(band_of(0, 0.1), {}, p).v, 0.1);
  EXPECT_EQ(follow(band_of(0, 0), {}, p).v, 0.1);
  EXPECT_EQ(follow(band_of(0, 2), {}, p).v, 0.5);
  EXPECT_EQ(follow(band_of(0), {}, p).w, 0);
}

TEST(FollowBand, TurnsToTheNextBubbleAndIsSlowerThen) {
  ControllerParameters p = parameters();
  const Twist left = follow(band_of(0.1, 0.4), {}, p);
  EXPECT_NEAR(left.w, 0.4, 1e-12) << "k_prop times the bearing";
  EXPECT_NEAR(left.v, 0.28 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(follow(band_of(-0.1), {}, p).w, -0.4, 1e-12);
  EXPECT_EQ(follow(band_of(0.4), {}, p).w, 1) << "max_vel_th";
  p.min_vel_th = 0.2;
  EXPECT_EQ(follow(band_of(-0.01), {}, p).w, -0.2);
}

TEST(FollowBand, RotatesInPlaceBeyondTheAngleThatTheNextBubbleSubtends) {
  ControllerParameters p = parameters();
  // atan(0.7 * 0.5 / 0.6) = 0.528 rad, of a bubble of 0.2 m 0.229 rad.
  EXPECT_GT(follow(band_of(0.52), {}, p).v, 0);
  EXPECT_EQ(follow(band_of(0.54), {}, p).v, 0);
  EXPECT_EQ(follow(band_of(0.54), {}, p).w, 1);
  EXPECT_EQ(follow(band_of(-0.24, 0.5, 0.2), {}, p).v, 0);
  EXPECT_NEAR(follow(band_of(-0.24, 0.5, 0.2), {}, p).w, -0.96, 1e-12);
  p.rotation_threshold_multiplier = 2;
  EXPECT_GT(follow(band_of(0.54), {}, p).v, 0);
  p.min_in_place_vel_th = 0.99;
  p.rotation_threshold_multiplier = 0.1;
  EXPECT_EQ(follow(band_of(0.2, 0.5, 0.2), {}, p).w, 0.99);
}

TEST(FollowBand, IsInTheFrameOfTheBand) {
  // The robot at (2, 1) looks up; the next bubble is above it and a bit to its left.
  const std::vector<Bubble> band = {{{2, 1}, 0.4}, {{1.9, 1.5}, 0.4}};
  const Twist twist = follow(band, {2, 1, M_PI / 2}, parameters());
  EXPECT_GT(twist.v, 0);
  EXPECT_NEAR(twist.w, 4 * std::atan2(0.1, 0.5), 1e-12);
}

}  // namespace
}  // namespace eband_local_planner
