// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/random.h>
#include <slalom/robot/footprint.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

std::string refusal(const std::string& text) {
  try {
    Footprint::parse(text);
  } catch (const std::invalid_argument& expected) {
    return expected.what();
  }
  return "";
}

TEST(Footprint, ThinPolygonsOfAnyLengthHaveAllTheirCorners) {
  for (const std::string text : {"-1e30,-0.1; 1e30,-0.1; 0,0.1", "-9,-0.001; 9,-0.001; 0,0.001"})
    EXPECT_EQ(Footprint::parse(text).corners().size(), 3U) << text;
}

TEST(Footprint, ADiscHasOneRadius) {
  const Footprint disc = Footprint::disc(0.3);
  EXPECT_TRUE(disc.is_disc());
  EXPECT_EQ(disc.inscribed_radius(), 0.3);
  EXPECT_EQ(disc.enclosing_radius(), 0.3);
}

TEST(Footprint, APolygonHasAnInscribedAndAnEnclosingRadius) {
  // A rectangle from x = -0.2 to 0.4, 0.25 to either side: the rear is nearest, the front corners
  // are farthest.
  const Footprint rectangle = Footprint::parse("0.4,0.25; -0.2,0.25; -0.2,-0.25; 0.4,-0.25");
  EXPECT_DOUBLE_EQ(rectangle.inscribed_radius(), 0.2);
  EXPECT_DOUBLE_EQ(rectangle.enclosing_radius(), std::hypot(0.4, 0.25));
}

TEST(Footprint, CornersMayBeInEitherOrder) {
  const Footprint left = Footprint::parse("1,0; 0,1; -1,-1");
  const Footprint right = Footprint::parse("-1,-1; 0,1; 1,0");
  EXPECT_EQ(left.inscribed_radius(), right.inscribed_radius());
  const auto& c = right.corners();
  const auto turn = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
  EXPECT_GT(turn, 0) << "kept counter-clockwise";
}

TEST(Footprint, CornersMoveWithTheRobot) {
  const Footprint triangle = Footprint::parse("1,0; -1,1; -1,-1");
  const auto corners = triangle.corners_at({10, 20, M_PI / 2});
  EXPECT_NEAR(corners[0].x, 10, 1e-12);
  EXPECT_NEAR(corners[0].y, 21, 1e-12);
  EXPECT_NEAR(corners[1].x, 9, 1e-12);
  EXPECT_NEAR(corners[1].y, 19, 1e-12);
}

TEST(Footprint, EveryCornerOfARandomPolygonLiesBetweenItsRadii) {
  RandomEngine random(3);
  for (int n = 0; n < 200; ++n) {
    std::string text;
    const int corners = uniform_int(random, 3, 9);
    const double radius = uniform_real(random, 0.1, 2);
    for (int i = 0; i < corners; ++i) {  // on a circle: always convex
      const double angle = 2 * M_PI * (i + uniform_real(random, 0, 0.3)) / corners;
      text += (i > 0 ? ";" : "") + std::to_string(radius * std::cos(angle)) + "," +
              std::to_string(radius * std::sin(angle));
    }
    const Footprint footprint = Footprint::parse(text);
    EXPECT_NEAR(footprint.enclosing_radius(), radius, 1e-5);
    EXPECT_LT(footprint.inscribed_radius(), radius);
    EXPECT_GT(footprint.inscribed_radius(), 0);
  }
}

TEST(Footprint, CornersOnAStraightSideChangeNothing) {
  const std::string square = "0.2,0.2; -0.2,0.2; -0.2,-0.2; 0.2,-0.2";
  const auto expected = Footprint::parse(square).corners();
  for (const std::string same : {"0.2,0.2; 0,0.2; -0.2,0.2; -0.2,-0.2; 0.2,-0.2",
                                 "0.2,0.2; 0.1,0.2; 0,0.2; -0.2,0.2; -0.2,-0.2; 0.2,-0.2; 0.2,0"})
    EXPECT_EQ(Footprint::parse(same).corners(), expected) << same;
  // On the side from (-0.1, 0.2) to (0.5, -0.4), but for the rounding of decimal numbers.
  EXPECT_EQ(Footprint::parse("-0.1,0.2; -0.2,-0.4; 0.5,-0.4; 0.2,-0.1; 0.1,0").corners().size(),
            3U);
}

TEST(Footprint, APolygonMayBeClosed) {
  const std::string square = "0.2,0.2; -0.2,0.2; -0.2,-0.2; 0.2,-0.2";
  const auto expected = Footprint::parse(square).corners();
  EXPECT_EQ(Footprint::parse(square + "; 0.2,0.2").corners(), expected);
  EXPECT_EQ(Footprint::parse("0.2,0.2; " + square).corners(), expected);
}

TEST(Footprint, ReadsTheSyntaxOfRos) {
  const auto expected =
      Footprint::parse("-0.3,-0.3; -0.3,0.3; 0.3,0.3; 0.45,0; 0.3,-0.3").corners();
  for (const std::string ros :
       {"[[-0.3, -0.3], [-0.3, 0.3], [0.3, 0.3], [0.45, 0.0], [0.3, -0.3]]",
        " [ [-0.3,-0.3],[-0.3,0.3] , [0.3,0.3],[0.45,0.0], [ 0.3,-0.3 ] ] "})
    EXPECT_EQ(Footprint::parse(ros).corners(), expected) << ros;
  for (const std::string wrong :
       {"[", "]", "[]", "[[]]", "[[1, 0], [0, 1], [-1, -1]", "[1, 0], [0, 1], [-1, -1]",
        "[[1, 0] [0, 1] [-1, -1]]", "[[1, 0], [0, 1], [-1, -1],]", "[[1, 0], [0, 1], [-1]]",
        "[[1, 0], [0, 1], x[-1, -1]]", "[,[1, 0], [0, 1], [-1, -1]]"})
    EXPECT_TRUE(mentions(refusal(wrong), {"x,y", "[[x, y], [x, y], ...]"})) << wrong;
}

TEST(Footprint, NamesTheCornerThatIsNotConvex) {
  EXPECT_TRUE(mentions(refusal("1,1; 0,0.1; -1,1; -1,-1; 1,-1"), {"inward at corner 2, 0,0.1"}));
  EXPECT_TRUE(mentions(refusal("1,-1; -1,-1; -1,1; 0,0.1; 1,1"), {"inward at corner 4, 0,0.1"}));
  // Corners that are left out are counted.
  EXPECT_TRUE(
      mentions(refusal("1,1; 0.5,0.55; 0,0.1; -1,1; -1,-1; 1,-1"), {"inward at corner 3, 0,0.1"}));
  // A side that goes back on itself.
  EXPECT_TRUE(mentions(refusal("1,1; -1,1; -1,-1; 2,-1; 1,-1"), {"inward at corner 4, 2,-1"}));
  EXPECT_TRUE(mentions(refusal("-1,0; 1,0; 0,0"), {"convex polygon", "on one line"}));
}

TEST(Footprint, RefusesOtherThanConvexPolygonsAroundTheCenter) {
  EXPECT_TRUE(mentions(refusal("1,0; 0,1"), {"3 to 64 corners"}));
  EXPECT_TRUE(mentions(refusal("1,0; 0,1; x,2"), {"x,y", "';'"}));
  EXPECT_TRUE(mentions(refusal("1,0; 0,1; 1"), {"x,y", "';'"}));
  EXPECT_TRUE(mentions(refusal("1,1; 0,0.1; -1,1; -1,-1; 1,-1"), {"convex polygon"}));
  EXPECT_TRUE(mentions(refusal("1,0; 1,0; 1,0"), {"convex polygon"}));
  // A five-pointed star turns left at every corner, but by 4 pi in total.
  EXPECT_TRUE(
      mentions(refusal("1,0; -0.8,0.6; 0.3,-0.95; 0.3,0.95; -0.8,-0.6"), {"convex polygon"}));
  EXPECT_TRUE(mentions(refusal("1,0; 2,0; 2,1"), {"polygon around", "(0, 0)"}));
}

TEST(Footprint, AMalformedOptionIsNamed) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--footprint", {"'1,0; 0,1'", "3 to 64 corners"},
                           [] { Footprint::parse("1,0; 0,1", "--footprint"); }));
}

}  // namespace
}  // namespace slalom
