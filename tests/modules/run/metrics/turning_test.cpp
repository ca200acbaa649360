// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

/// 1.25 turns on a circle of this radius around (5, 5) at 1 m/s, from its lowest point: the heading
/// crosses +-pi.
struct Circle : SampledRun {
  explicit Circle(double radius, double hz = 10)
      : SampledRun(2.5 * M_PI * radius, hz, [=](double t) {
          const double angle = t / radius - M_PI / 2;
          Sample sample;
          sample.pose = {5 + radius * std::cos(angle), 5 + radius * std::sin(angle),
                         std::remainder(angle + M_PI / 2, 2 * M_PI)};
          sample.v = 1;
          sample.w = 1 / radius;
          return sample;
        }) {}
};

TEST(AngleOverLength, OfACircleIsOneOverItsRadius) {
  for (const double radius : {0.5, 1.0, 2.0})
    for (const double hz : {10.0, 20.0, 50.0})  // the first and last segment turn only by half
      EXPECT_NEAR(Circle(radius, hz).number("angle_over_length"), 1 / radius, 0.03 / radius);
}

TEST(CumulativeHeadingChange, OfACircleThatCrossesPiIsItsAngle) {
  EXPECT_NEAR(Circle(1).number("cumulative_heading_change"), 2.5 * M_PI, 0.05);
}

TEST(CumulativeHeadingChange, CountsBothDirections) {
  MeasuredRun run({{2, 5}, {2, 5}, {2, 5}});
  run.trajectory.samples[0].pose.phi = 3.1;
  run.trajectory.samples[1].pose.phi = -3.1;
  run.trajectory.samples[2].pose.phi = 3.0;
  EXPECT_NEAR(run.number("cumulative_heading_change"), (2 * M_PI - 6.2) + (2 * M_PI - 6.1), 1e-12);
}

TEST(AngleOverLength, OfCornersIsTheirAngles) {
  // Left by 90 degrees, right by 45 degrees, over 2 + 2 + sqrt 2 m.
  const MeasuredRun run({{2, 5}, {4, 5}, {4, 7}, {5, 8}});
  EXPECT_NEAR(run.number("angle_over_length"), 0.75 * M_PI / (4 + std::sqrt(2)), 1e-12);
}

TEST(AngleOverLength, DependsOnThePathNotOnTheHeading) {
  MeasuredRun run({{2, 5}, {4, 5}, {6, 5}});
  run.trajectory.samples[1].pose.phi = 2;
  EXPECT_EQ(run.number("angle_over_length"), 0);
}

TEST(AngleOverLength, IgnoresRoundingNoiseOfAStoppedRobot) {
  MeasuredRun run({{2, 5}, {4, 5}, {4 + 1e-12, 5 + 1e-12}, {4, 5 + 1e-12}, {6, 5}});
  EXPECT_NEAR(run.number("angle_over_length"), 0, 1e-9);
  EXPECT_EQ(MeasuredRun({{2, 5}, {2, 5 + 1e-12}}).reason("angle_over_length"),
            "the robot did not move");
}

TEST(PathIrregularity, IsTheExcessRotationOverTheShortestPath) {
  MeasuredRun run({{2, 5}, {5, 6}, {8, 5}});
  const double turn = 2 * std::atan2(1, 3), traveled = 2 * std::sqrt(10);
  EXPECT_NEAR(run.number("path_irregularity"), turn / traveled, 1e-12);
  run.set_shortest({{2, 5}, {5, 5.5}, {8, 5}});
  EXPECT_NEAR(run.number("path_irregularity"), (turn - 2 * std::atan2(0.5, 3)) / traveled, 1e-12);
  run.set_shortest({{2, 5}, {5, 8}, {8, 5}});
  EXPECT_EQ(run.number("path_irregularity"), 0);
}

}  // namespace
}  // namespace slalom::testing
