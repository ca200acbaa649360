#include <slalom/gui/view_transform.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void expect_at(const TPoint2D& point, double x, double y) {
  EXPECT_NEAR(point.x, x, 1e-9);
  EXPECT_NEAR(point.y, y, 1e-9);
}

/// 20 m x 10 m on 240 x 140 pixels with margins of 20: 10 pixels per m.
const ViewTransform kView = ViewTransform::fitting({-10, 0, 10, 10}, 100, 50, 240, 140, 20);

TEST(ViewTransform, FitsAllWithinTheMarginsAndTurnsYUp) {
  EXPECT_DOUBLE_EQ(kView.pixels_per_metre(), 10);
  expect_at(kView.to_screen({0, 5}), 220, 120);
  expect_at(kView.to_screen({-10, 10}), 120, 70);
  expect_at(kView.to_screen({10, 0}), 320, 170);
}

TEST(ViewTransform, GoesToTheScreenAndBack) {
  expect_at(kView.to_world(kView.to_screen({3.25, 7.5})), 3.25, 7.5);
  const Bounds seen = kView.visible();
  EXPECT_DOUBLE_EQ(seen.x_min, -12);
  EXPECT_DOUBLE_EQ(seen.x_max, 12);
  EXPECT_DOUBLE_EQ(seen.y_min, -2);
  EXPECT_DOUBLE_EQ(seen.y_max, 12);
}

TEST(ViewTransform, ZoomsAboutThePointUnderTheMouse) {
  const TPoint2D mouse(150, 80), under = kView.to_world(mouse);
  const ViewTransform closer = kView.zoomed(mouse, 2.5);
  EXPECT_DOUBLE_EQ(closer.pixels_per_metre(), 25);
  expect_at(closer.to_screen(under), 150, 80);
}

TEST(ViewTransform, NeverZoomsBeyondItsLimits) {
  EXPECT_EQ(kView.zoomed({0, 0}, 1e12).pixels_per_metre(), ViewTransform::kLargestScale);
  EXPECT_EQ(kView.zoomed({0, 0}, 1e-12).pixels_per_metre(), ViewTransform::kLeastScale);
}

TEST(ViewTransform, PansWithTheMouse) {
  expect_at(kView.panned(7, -3).to_screen({0, 5}), 227, 117);
}

TEST(ViewTransform, KeepsWhatIsSeenOnAnotherRectangle) {
  const ViewTransform other = kView.on(0, 0, 480, 280);
  EXPECT_DOUBLE_EQ(other.pixels_per_metre(), 20);
  expect_at(other.to_screen({0, 5}), 240, 140);
}

}  // namespace
}  // namespace slalom
