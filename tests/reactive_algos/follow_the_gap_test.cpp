// SPDX-License-Identifier: BSD-3-Clause
#include "follow_the_gap.h"
#include "walls.h"

#include <gtest/gtest.h>

namespace follow_the_gap {
namespace {

constexpr double kDegree = M_PI / 180;

Twist decide_once(const std::vector<Wall>& walls, double goal_x, double goal_y) {
  int last_side = 0;
  return decide(scan_of(walls), goal_x, goal_y, {}, {}, last_side);
}

TEST(RayAngle, IncreasesFromRightToLeft) {
  EXPECT_DOUBLE_EQ(ray_angle(0, 181, M_PI), -M_PI / 2);
  EXPECT_DOUBLE_EQ(ray_angle(90, 181, M_PI), 0);
  EXPECT_DOUBLE_EQ(ray_angle(180, 181, M_PI), M_PI / 2);
  EXPECT_DOUBLE_EQ(ray_angle(0, 1, M_PI), 0);
}

TEST(FindGaps, FreeSpaceIsOneGap) {
  const auto gaps = find_gaps(scan_of({}), M_PI, 0.35, 2.5);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_DOUBLE_EQ(gaps[0].low, -M_PI / 2);
  EXPECT_DOUBLE_EQ(gaps[0].high, M_PI / 2);
}

TEST(FindGaps, APointClosesTheAngularWidthOfItsCircle) {
  std::vector<double> ranges(181, 8.0);
  ranges[90] = 1.0;
  // asin(0.35 / 1) is 20.5 degrees: rays -20 to 20 are closed.
  const auto gaps = find_gaps(ranges, M_PI, 0.35, 2.5);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_NEAR(gaps[0].low, -90 * kDegree, 1e-9);
  EXPECT_NEAR(gaps[0].high, -21 * kDegree, 1e-9);
  EXPECT_NEAR(gaps[1].low, 21 * kDegree, 1e-9);
  EXPECT_NEAR(gaps[1].high, 90 * kDegree, 1e-9);
}

TEST(FindGaps, APointInsideTheRobotClosesAHalfCircle) {
  std::vector<double> ranges(181, 8.0);
  ranges[180] = 0.3;  // at 90 degrees, closer than the radius: closes 0 to 90 degrees
  const auto gaps = find_gaps(ranges, M_PI, 0.35, 2.5);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_NEAR(gaps[0].high, -1 * kDegree, 1e-9);
}

TEST(FindGaps, ObstaclesBeyondTheHorizonCloseNoGap) {
  EXPECT_EQ(find_gaps(scan_of({{3, -20, 3, 20}}), M_PI, 0.35, 2.5).size(), 1U);
}

const Gap* gap_ahead(const std::vector<Gap>& gaps) {
  for (const Gap& gap : gaps)
    if (gap.contains(0)) return &gap;
  return nullptr;
}

TEST(FindGaps, OnlyAWideOpeningIsAGap) {
  // 1 m ahead. At both edges a circle of 0.35 m reaches 0.35 m into the opening.
  EXPECT_EQ(gap_ahead(find_gaps(scan_of(wall_with_opening(1, -0.3, 0.3)), M_PI, 0.35, 5)), nullptr);
  const auto gaps = find_gaps(scan_of(wall_with_opening(1, -1, 1)), M_PI, 0.35, 5);
  const Gap* ahead = gap_ahead(gaps);
  ASSERT_NE(ahead, nullptr);
  // The edge, seen at 45 degrees from 1.414 m, closes asin(0.35 / 1.414) = 14.3 degrees more.
  EXPECT_NEAR(ahead->high, 30 * kDegree, 1.5 * kDegree);
  EXPECT_NEAR(ahead->low, -30 * kDegree, 1.5 * kDegree);
}

TEST(ChooseGap, SelectsTheWidestOfTwoAtTheSameAngle) {
  const std::vector<Gap> gaps = {{-1.0, -0.5}, {0.5, 1.4}};
  EXPECT_EQ(choose_gap(gaps, 0, 0.6), &gaps[1]);
  EXPECT_EQ(choose_gap({}, 0, 0.6), nullptr);
}

TEST(ChooseGap, PrefersANarrowerGapTowardsTheGoal) {
  // Value width - 2 * 0.6 * angle from the goal: 0.4 against 0.9 - 1.2 * 1.0 < 0.
  const std::vector<Gap> gaps = {{-1.2, -0.8}, {0.0, 0.9}};
  EXPECT_EQ(choose_gap(gaps, -1.0, 0.6), &gaps[0]);
  EXPECT_EQ(choose_gap(gaps, -1.0, 0.0), &gaps[1]);
}

TEST(FinalHeading, WeightsGapCenterAndGoalByTheClosestObstacle) {
  // Eq. (8): (alpha / nearest * center + goal) / (alpha / nearest + 1), alpha = 1.
  const Gap gap{0.2, 1.0};
  EXPECT_NEAR(final_heading(gap, 0.3, 1.0, 1.0), (0.6 + 0.3) / 2, 1e-12);
  EXPECT_NEAR(final_heading(gap, 0.3, 0.25, 1.0), (4 * 0.6 + 0.3) / 5, 1e-12);
  EXPECT_NEAR(final_heading(gap, 0.3, 1.0, 0.0), 0.3, 1e-12);
}

TEST(FinalHeading, StaysInTheGap) {
  EXPECT_DOUBLE_EQ(final_heading({0.2, 1.0}, -3, 100, 1), 0.2);
  EXPECT_DOUBLE_EQ(final_heading({0.2, 1.0}, 3, 100, 1), 1.0);
}

TEST(FreeDistanceAhead, EndsAtContact) {
  EXPECT_DOUBLE_EQ(free_distance_ahead(scan_of({}), M_PI, 8, 0.25), 8);
  EXPECT_NEAR(free_distance_ahead(scan_of({{2, -20, 2, 20}}), M_PI, 8, 0.25), 1.75, 1e-9);
  // A wall 0.3 m to the left does not block a robot of radius 0.25 m.
  EXPECT_DOUBLE_EQ(free_distance_ahead(scan_of({{-5, 0.3, 5, 0.3}}), M_PI, 8, 0.25), 8);
  EXPECT_DOUBLE_EQ(free_distance_ahead(scan_of({{0.2, -20, 0.2, 20}}), M_PI, 8, 0.25), 0);
}

TEST(Decide, MovesStraightToTheGoalInFreeSpace) {
  const Twist ahead = decide_once({}, 6, 0);
  EXPECT_DOUBLE_EQ(ahead.v, Robot{}.max_v);
  EXPECT_DOUBLE_EQ(ahead.w, 0);
  // At a bearing of 0.5 rad: w = turn_gain * 0.5, v = max_v * cos 0.5.
  const Twist aside = decide_once({}, 5 * std::cos(0.5), 5 * std::sin(0.5));
  EXPECT_NEAR(aside.w, 1.0, 1e-9);
  EXPECT_NEAR(aside.v, std::cos(0.5), 1e-9);
}

TEST(Decide, ALookAheadBeyondTheSensorClosesNoFreeSpace) {
  Parameters parameters;
  parameters.look_ahead = 20;
  int last_side = 0;
  const Twist ahead = decide(scan_of({}), 15, 0, parameters, {}, last_side);
  EXPECT_DOUBLE_EQ(ahead.v, Robot{}.max_v);
  EXPECT_DOUBLE_EQ(ahead.w, 0);
}

TEST(Decide, RotatesInPlaceTowardsAGoalBesideOrBehind) {
  const Twist left = decide_once({}, -1, 3);
  EXPECT_EQ(left.v, 0);
  EXPECT_EQ(left.w, Robot{}.max_w);
  const Twist right = decide_once({}, -1, -3);
  EXPECT_EQ(right.v, 0);
  EXPECT_EQ(right.w, -Robot{}.max_w);
}

TEST(Decide, TurnsTowardsTheOpeningOfAWallAhead) {
  EXPECT_GT(decide_once(wall_with_opening(1.5, 1, 4), 6, 0).w, 0);
  EXPECT_LT(decide_once(wall_with_opening(1.5, -4, -1), 6, 0).w, 0);
}

TEST(Decide, DoesNotEnterAnOpeningNarrowerThanItself) {
  // An opening of 0.4 m for a robot 0.5 m wide, 1 m ahead; there is a free passage on the left.
  std::vector<Wall> walls = {{1, -20, 1, -0.2}, {1, 0.2, 1, 1.5}};
  const Twist twist = decide_once(walls, 6, 0);
  EXPECT_GT(twist.w, 0);
  const double stop = std::sqrt(2 * 0.7 * (0.8 - 0.05));  // from the edges, at most 0.8 m away
  EXPECT_LE(twist.v, stop);
}

TEST(Decide, StopsAndRotatesInPlaceWhenBlocked) {
  const std::vector<Wall> box = {{0.5, -0.5, 0.5, 0.5}, {-1, 0.5, 0.5, 0.5}, {-1, -0.5, 0.5, -0.5}};
  const Twist twist = decide_once(box, 5, 0.1);
  EXPECT_EQ(twist.v, 0);
  EXPECT_EQ(twist.w, Robot{}.max_w);
}

TEST(Decide, LooksLessFarAheadWhereNothingIsFreeThatFar) {
  // A corner of 2 m x 2 m: no direction is free for 2.5 m, many are for 1.6 m.
  const std::vector<Wall> corner = {{2, -8, 2, 2}, {-8, 2, 2, 2}, {-8, -2, 2, -2}};
  const Twist twist = decide_once(corner, 6, 0);
  EXPECT_GT(twist.v, 0);
}

TEST(Decide, KeepsItsSideWhileBlocked) {
  const std::vector<Wall> box = {{0.5, -0.5, 0.5, 0.5}, {-1, 0.5, 0.5, 0.5}, {-1, -0.5, 0.5, -0.5}};
  int last_side = 0;
  decide(scan_of(box), 5, -1, {}, {}, last_side);
  EXPECT_EQ(last_side, -1);
  EXPECT_EQ(decide(scan_of(box), 5, 1, {}, {}, last_side).w, -Robot{}.max_w);
  decide(scan_of({}), 5, 1, {}, {}, last_side);
  EXPECT_EQ(last_side, 0);
}

TEST(StopBeforeTurning, DoesNotTurnWhileTheRobotStillMoves) {
  Robot robot;
  robot.max_accel_v = 2;
  const Twist in_place{0, 1}, ahead{0.3, 1};
  // 2 m/s^2 for 0.1 s: up to 0.2 m/s the robot stops within the period.
  EXPECT_EQ(stop_before_turning(in_place, 0.21, robot, 0.1).w, 0);
  EXPECT_EQ(stop_before_turning(in_place, 0.21, robot, 0.1).v, 0);
  EXPECT_EQ(stop_before_turning(in_place, 0.19, robot, 0.1).w, 1);
  EXPECT_EQ(stop_before_turning(ahead, 1.0, robot, 0.1).w, 1);
}

TEST(Decide, CanAlwaysStopBeforeAnObstacleAhead) {
  const Robot robot;
  for (double distance = 0.3; distance < 4; distance += 0.1) {
    const Twist twist = decide_once({{distance, -20, distance, 20}}, 10, 0);
    const double free_distance = distance - robot.radius;
    EXPECT_LE(twist.v * twist.v / (2 * robot.max_accel_v), free_distance) << distance;
    EXPECT_GE(twist.v, 0);
    EXPECT_LE(std::abs(twist.w), robot.max_w);
  }
}

}  // namespace
}  // namespace follow_the_gap
