// SPDX-License-Identifier: BSD-3-Clause
#include "views/view_layout.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void expect_at(const TPoint2D& point, double x, double y) {
  EXPECT_NEAR(point.x, x, 1e-9);
  EXPECT_NEAR(point.y, y, 1e-9);
}

/// 20 m x 10 m on 240 x 140 pixels with margins of 20: 10 pixels per m.
const ViewTransform kView = ViewTransform::fitting({-10, 0, 10, 10}, {100, 50, 240, 140}, 20);

TEST(ViewTransform, FitsTheBoundsWithinTheMarginsWithYUp) {
  EXPECT_DOUBLE_EQ(kView.pixels_per_meter(), 10);
  expect_at(kView.to_screen({0, 5}), 220, 120);
  expect_at(kView.to_screen({-10, 10}), 120, 70);
  expect_at(kView.to_screen({10, 0}), 320, 170);
}

TEST(ViewTransform, ConvertsToTheScreenAndBack) {
  expect_at(kView.to_world(kView.to_screen({3.25, 7.5})), 3.25, 7.5);
  const Bounds visible = kView.visible();
  EXPECT_DOUBLE_EQ(visible.x_min, -12);
  EXPECT_DOUBLE_EQ(visible.x_max, 12);
  EXPECT_DOUBLE_EQ(visible.y_min, -2);
  EXPECT_DOUBLE_EQ(visible.y_max, 12);
}

TEST(ViewTransform, ZoomsAboutThePointUnderTheMouse) {
  const TPoint2D mouse(150, 80), under = kView.to_world(mouse);
  const ViewTransform closer = kView.zoomed(mouse, 2.5);
  EXPECT_DOUBLE_EQ(closer.pixels_per_meter(), 25);
  expect_at(closer.to_screen(under), 150, 80);
}

TEST(ViewTransform, NeverZoomsBeyondItsLimits) {
  EXPECT_EQ(kView.zoomed({0, 0}, 1e12).pixels_per_meter(), ViewTransform::kMaxScale);
  EXPECT_EQ(kView.zoomed({0, 0}, 1e-12).pixels_per_meter(), ViewTransform::kMinScale);
}

TEST(ViewTransform, PansWithTheMouse) {
  expect_at(kView.panned(7, -3).to_screen({0, 5}), 227, 117);
}

TEST(ViewTransform, KeepsTheVisibleAreaOnAnotherRectangle) {
  const ViewTransform other = kView.on({0, 0, 480, 280});
  EXPECT_DOUBLE_EQ(other.pixels_per_meter(), 20);
  expect_at(other.to_screen({0, 5}), 240, 140);
}

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
  // 140 pixels at 30 pixels per m are 4.67 m: 2 m fit, 5 m do not.
  const ScaleBar bar = ScaleBar::choose(30, 140);
  EXPECT_DOUBLE_EQ(bar.meters, 2);
  EXPECT_DOUBLE_EQ(bar.pixels, 60);
  EXPECT_DOUBLE_EQ(ScaleBar::choose(28, 140).meters, 5);   // exactly
  EXPECT_DOUBLE_EQ(ScaleBar::choose(140, 140).meters, 1);  // exactly
  EXPECT_DOUBLE_EQ(ScaleBar::choose(20000, 140).meters, 0.005);
  EXPECT_DOUBLE_EQ(ScaleBar::choose(0.01, 140).meters, 10000);
}

TEST(ScaleBar, FillsAtLeastTwoFifthsOfTheMaximum) {
  for (double scale = 0.01; scale < 20000; scale *= 1.07) {
    const ScaleBar bar = ScaleBar::choose(scale, 140);
    EXPECT_LE(bar.pixels, 140 * (1 + 1e-6)) << scale;
    EXPECT_GE(bar.pixels, 140 * 0.4 * (1 - 1e-6)) << scale;  // steps of at most 2.5
  }
}

TEST(ScaleBar, IsLabeledInASuitableUnit) {
  EXPECT_EQ((ScaleBar{0.005, 0}.text()), "5 mm");
  EXPECT_EQ((ScaleBar{0.2, 0}.text()), "20 cm");
  EXPECT_EQ((ScaleBar{50, 0}.text()), "50 m");
  EXPECT_EQ((ScaleBar{2000, 0}.text()), "2 km");
}

}  // namespace
}  // namespace slalom
