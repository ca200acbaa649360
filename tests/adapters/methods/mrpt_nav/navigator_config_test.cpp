// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "navigator_config.h"
#include "navigator_fixture.h"
#include "noted_config.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// The smallest distance of the outline's edges and the largest of its corners from the center.
std::pair<double, double> distance_range(const std::vector<mrpt::math::TPoint2D>& outline) {
  double nearest = 1e9, farthest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    nearest = std::min(nearest, (a.x * b.y - a.y * b.x) / std::hypot(b.x - a.x, b.y - a.y));
    farthest = std::max(farthest, std::hypot(a.x, a.y));
  }
  return {nearest, farthest};
}

TEST(EnlargedOutline, OfADiscEnclosesIt) {
  const auto [nearest, farthest] = distance_range(enlarged_outline(Footprint::disc(0.25), 0.05));
  EXPECT_NEAR(nearest, 0.3, 1e-12);
  EXPECT_LT(farthest, 0.3 * 1.02);
}

TEST(EnlargedOutline, OfARectangleIsLargerByTheMarginOnEachSide) {
  const auto outline =
      enlarged_outline(Footprint::parse("0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2"), 0.05);
  ASSERT_EQ(outline.size(), 4U);
  for (const auto& corner : outline) {
    EXPECT_NEAR(std::abs(corner.x), 0.35, 1e-12);
    EXPECT_NEAR(std::abs(corner.y), 0.25, 1e-12);
  }
}

TEST(NavigatorConfig, ReadsDefinitionsAndContinuedLines) {
  const auto config = read_navigator_config(stock_config());
  EXPECT_EQ(config.read_double("CReactiveNavigationSystem", "PTG0_v_max_mps", 0), 1);
  EXPECT_NE(config.read_string("CMultiObjectiveMotionOptimizerBase", "score1_formula", "")
                .find("effective_trg_d_norm^2"),
            std::string::npos);
  EXPECT_THROW(read_navigator_config("/nowhere"), std::runtime_error);
  EXPECT_THROW(read_navigator_config("/"), std::runtime_error);
}

TEST(NavigatorConfig, OverridesValuesOfTheFile) {
  auto config = read_navigator_config(stock_config());
  const std::string section = "CReactiveNavigationSystem";
  override_config(
      config, "CAbstractPTGBasedReactive.ref_distance=4; " + section + ".PTG0_refDistance = 3.5;",
      "a.ini:3");
  EXPECT_EQ(config.read_double("CAbstractPTGBasedReactive", "ref_distance", 0), 4);
  EXPECT_EQ(config.read_double(section, "PTG0_refDistance", 0), 3.5);
  EXPECT_EQ(config.read_double(section, "PTG1_refDistance", 0), 10);
  const auto refuses = [&](const std::string& text, std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "a.ini:3: ", words,
                        [&] { override_config(config, text, "a.ini:3"); });
  };
  EXPECT_TRUE(refuses("ref_distance=4", {"'ref_distance=4'", "expected SECTION.KEY=VALUE"}));
  EXPECT_TRUE(refuses("Nowhere.a=4", {"no section [Nowhere]", "expected a section of config"}));
}

TEST(NavigatorConfig, OverridesAreOfKeysThatAreRead) {
  const NotedConfig config(read_navigator_config(test_config("small_navigator.ini")));
  config.read_string("CHolonomicND", "TOO_CLOSE_OBSTACLE", "");
  require_overrides(config, "CHolonomicND.too_close_obstacle=1", "a.ini:3");
  const auto refuses = [&](const std::string& text, std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, "a.ini:3: ", words,
                        [&] { require_overrides(config, text, "a.ini:3"); });
  };
  EXPECT_TRUE(refuses(
      "CHolonomicND.TOO_CLOSE_OBSTACL=1",
      {"nobody reads TOO_CLOSE_OBSTACL in [CHolonomicND]", "expected 'TOO_CLOSE_OBSTACLE'"}));
  EXPECT_TRUE(refuses("CHolonomicVFF.TOO_CLOSE_OBSTACLE=1", {"a key that the class reads"}));
}

TEST(NavigatorConfig, KnowsTheValueOfAKey) {
  const auto config = read_navigator_config(test_config("small_navigator.ini"));
  const auto value = [&](const std::string& overrides, const std::string& name) {
    return value_of_key(config, overrides, name, "a.ini:3");
  };
  EXPECT_EQ(value("", "CHolonomicND.RISK_EVALUATION_DISTANCE"), "0.4");
  EXPECT_EQ(value("A.b=1; A.b = 2;", "A.b"), "2");
  EXPECT_EQ(value("", "CHolonomicND.nothing"), std::nullopt);
}

TEST(NavigatorConfig, WritesTheRobotsShapeAndLimitsToTheNavigatorsKeys) {
  auto config = read_navigator_config(test_config("small_navigator.ini"));
  RobotModel robot;
  // With a notch ahead: the navigator is given the convex hull.
  robot.footprint = "0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2; 0.1,0";
  robot.max_v = 0.7;
  robot.max_w = 2;
  write_robot(config, robot, 0.1);
  const double degrees = 2 * 180 / M_PI;
  const std::string section_2d = "CReactiveNavigationSystem", section_3d = section_2d + "3D";
  EXPECT_NEAR(config.read_double("CAbstractPTGBasedReactive", "robotMax_V_mps", 0), 0.7, 1e-9);
  EXPECT_NEAR(config.read_double("CAbstractPTGBasedReactive", "robotMax_W_degps", 0), degrees,
              1e-3);
  EXPECT_NEAR(config.read_double(section_2d, "PTG0_v_max_mps", 0), 0.7, 1e-9);
  EXPECT_NEAR(config.read_double(section_3d, "PTG1_w_max_dps", 0), degrees, 1e-3);
  EXPECT_FALSE(
      config.keyExists(section_2d, "PTG1_v_max_mps"));  // only where the file has such a key
  const double radius = std::hypot(0.3, 0.2) + 0.1;
  EXPECT_NEAR(config.read_double(section_2d, "RobotModel_circular_shape_radius", 0), radius, 1e-6);
  std::vector<double> xs;
  config.read_vector(section_2d, "RobotModel_shape2D_xs", {}, xs);
  ASSERT_EQ(xs.size(), 4U);
  EXPECT_NEAR(std::abs(xs[0]), 0.4, 1e-9);
  config.read_vector(section_3d, "LEVEL1_VECTORY", {}, xs);
  ASSERT_EQ(xs.size(), 4U);
  EXPECT_NEAR(std::abs(xs[0]), 0.3, 1e-9);
}

}  // namespace
}  // namespace slalom
