// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/random.h>
#include <slalom/core/text.h>
#include <slalom/robot/footprint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

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

TEST(Footprint, HalfTheWidthIsThatToTheSideOfTheCenter) {
  EXPECT_EQ(Footprint::disc(0.3).half_width(), 0.3);
  EXPECT_EQ(Footprint::parse("0.8,0.2; -0.1,0.2; -0.1,-0.2; 0.8,-0.2").half_width(), 0.2);
  EXPECT_EQ(Footprint::parse("0.8,0.1; -0.1,0.1; -0.1,-0.3; 0.8,-0.3").half_width(), 0.3);
  EXPECT_EQ(passing_radius(0.9, Footprint::parse("0.8,0.2; -0.1,0.2; -0.1,-0.2; 0.8,-0.2")), 0.2);
  EXPECT_EQ(passing_radius(0.9, std::nullopt), 0.9);
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

/// A star around the center, whose corners are at random distances.
std::vector<TPoint2D> random_star(RandomEngine& random) {
  std::vector<TPoint2D> corners;
  const int n = uniform_int(random, 3, 12);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (i + uniform_real(random, 0, 0.2)) / n;
    const double radius = uniform_real(random, 0.1, 1);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

std::string text_of(const std::vector<TPoint2D>& corners) {
  std::string text;
  for (const TPoint2D& p : corners)
    text += (text.empty() ? "" : ";") + format_number(p.x) + "," + format_number(p.y);
  return text;
}

/// Twice the area of the triangle a, b, c; positive if it turns left.
double turn(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(Footprint, MayBeConcave) {
  // An L: the center is 0.1 m from the inner corner at (0.1, 0.1) along each axis.
  const Footprint l = Footprint::parse("-0.2,-0.2; 0.5,-0.2; 0.5,0.1; 0.1,0.1; 0.1,0.4; -0.2,0.4");
  EXPECT_EQ(l.corners().size(), 6U);
  EXPECT_NEAR(l.inscribed_radius(), std::sqrt(0.02), 1e-15);
  EXPECT_DOUBLE_EQ(l.enclosing_radius(), std::hypot(0.5, 0.2));
  const std::vector<TPoint2D>& hull = l.hull();
  ASSERT_EQ(hull.size(), 5U);
  EXPECT_EQ(std::count(hull.begin(), hull.end(), TPoint2D(0.1, 0.1)), 0);
}

TEST(Footprint, HasAConvexHullAroundItsCornersAndTheCircleOfItsNearestPoint) {
  RandomEngine random(5);
  int concave = 0;
  for (int n = 0; n < 300; ++n) {
    const std::vector<TPoint2D> corners = random_star(random);
    const Footprint star = Footprint::parse(text_of(corners));
    EXPECT_EQ(star.corners(), corners);
    const std::vector<TPoint2D>& hull = star.hull();
    for (std::size_t i = 0; i < hull.size(); ++i) {
      EXPECT_GT(turn(hull[i], hull[(i + 1) % hull.size()], hull[(i + 2) % hull.size()]), 0);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), hull[i]), 1);
      for (const TPoint2D& p : corners)
        EXPECT_GE(turn(hull[i], hull[(i + 1) % hull.size()], p), -1e-12);
    }
    if (hull.size() == corners.size()) {
      EXPECT_EQ(hull, corners);
    } else {
      ++concave;
    }
    double nearest = 1;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int k = 0; k < 1000; ++k) {
        const TPoint2D p =
            corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) * (k / 1000.0);
        nearest = std::min(nearest, std::hypot(p.x, p.y));
      }
    EXPECT_LE(star.inscribed_radius(), nearest + 1e-15);
    EXPECT_GT(star.inscribed_radius(), nearest - 2e-3);  // points of a side are 2 mm apart at most
  }
  EXPECT_GT(concave, 150);
}

TEST(Footprint, NamesSidesThatMeet) {
  // A bow tie; corners that are left out are counted.
  EXPECT_TRUE(mentions(refusal("1,1; -1,-1; 1,-1; -1,1"),
                       {"those from corner 1, 1,1 and from corner 3, 1,-1 do"}));
  EXPECT_TRUE(mentions(refusal("1,1; 0.5,0.5; -1,-1; 1,-1; -1,1"), {"corner 1, 1,1", "corner 4"}));
  // A corner on another side.
  EXPECT_TRUE(mentions(refusal("1,1; -1,1; -1,-1; 0,1; 1,-1"), {"do not meet", "corner 1, 1,1"}));
  // A side that goes back on itself.
  EXPECT_TRUE(mentions(refusal("1,1; -1,1; -1,-1; 2,-1; 1,-1"), {"goes back at corner 4, 2,-1"}));
  EXPECT_TRUE(mentions(refusal("-1,0; 1,0; 0,0"), {"do not meet", "on one line"}));
  EXPECT_TRUE(mentions(refusal("1,0; 1,0; 1,0"), {"do not meet", "on one line"}));
  // A five-pointed star turns left at every corner, but by 4 pi in total.
  EXPECT_TRUE(mentions(refusal("1,0; -0.8,0.6; 0.3,-0.95; 0.3,0.95; -0.8,-0.6"), {"do not meet"}));
}

TEST(Footprint, RefusesOtherThanPolygonsAroundTheCenter) {
  EXPECT_TRUE(mentions(refusal("1,0; 0,1"), {"3 to 64 corners"}));
  EXPECT_TRUE(mentions(refusal("1,0; 0,1; x,2"), {"x,y", "';'"}));
  EXPECT_TRUE(mentions(refusal("1,0; 0,1; 1"), {"x,y", "';'"}));
  EXPECT_TRUE(mentions(refusal("1,0; 2,0; 2,1"), {"polygon around", "(0, 0)"}));
  EXPECT_TRUE(mentions(refusal("1,1; -1,1; -1,-1; 1,-1; 1,-0.5; -0.5,-0.5; -0.5,0.5; 1,0.5"),
                       {"polygon around", "(0, 0)"}))
      << "the center is between the arms";
  EXPECT_TRUE(mentions(refusal("1,0; 0,0; -1,1; -1,-1"), {"polygon around", "(0, 0)"}));
}

TEST(Footprint, AMalformedOptionIsNamed) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--footprint", {"'1,0; 0,1'", "3 to 64 corners"},
                           [] { Footprint::parse("1,0; 0,1", "--footprint"); }));
}

}  // namespace
}  // namespace slalom
