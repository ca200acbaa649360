#include "error_text.h"
#include "navigator_config.h"
#include "navigator_drive.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

/// The smallest and largest distance of the outline's edges and corners from the centre.
std::pair<double, double> reach(const std::vector<mrpt::math::TPoint2D>& outline) {
  double nearest = 1e9, farthest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    nearest = std::min(nearest, (a.x * b.y - a.y * b.x) / std::hypot(b.x - a.x, b.y - a.y));
    farthest = std::max(farthest, std::hypot(a.x, a.y));
  }
  return {nearest, farthest};
}

TEST(EnlargedOutline, OfADiscLiesAroundIt) {
  const auto [nearest, farthest] = reach(enlarged_outline(Footprint::disc(0.25), 0.05));
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

TEST(NavigatorConfig, ReadsDefinitionsAndLinesThatGoOn) {
  const auto config = read_navigator_config(stock_config());
  EXPECT_EQ(config.read_double("CReactiveNavigationSystem", "PTG0_v_max_mps", 0), 1);
  EXPECT_NE(config.read_string("CMultiObjectiveMotionOptimizerBase", "score1_formula", "")
                .find("effective_trg_d_norm^2"),
            std::string::npos);
  EXPECT_THROW(read_navigator_config("/nowhere"), std::runtime_error);
  EXPECT_THROW(read_navigator_config("/"), std::runtime_error);
}

TEST(NavigatorConfig, PutsWhatIsSetInPlaceOfTheFiles) {
  auto config = read_navigator_config(stock_config());
  const std::string section = "CReactiveNavigationSystem";
  override_config(
      config, "CAbstractPTGBasedReactive.ref_distance=4; " + section + ".PTG0_refDistance = 3.5;",
      "a.ini:3");
  EXPECT_EQ(config.read_double("CAbstractPTGBasedReactive", "ref_distance", 0), 4);
  EXPECT_EQ(config.read_double(section, "PTG0_refDistance", 0), 3.5);
  EXPECT_EQ(config.read_double(section, "PTG1_refDistance", 0), 10);
  const auto refusal = [&](const std::string& text) {
    return error_text(Culprit::Usage, [&] { override_config(config, text, "a.ini:3"); });
  };
  EXPECT_EQ(refusal("ref_distance=4"),
            "a.ini:3: 'ref_distance=4' sets nothing; expected SECTION.KEY=VALUE; ...");
  EXPECT_EQ(
      refusal("Nowhere.a=4"),
      "a.ini:3: the navigator's file has no section [Nowhere]; expected a section of that file");
}

TEST(NavigatorConfig, TellsTheRobotsShapeAndLimitsWhereNavigatorsLookForThem) {
  auto config = read_navigator_config(test_config("small_navigator.ini"));
  RobotModel robot;
  robot.footprint = "0.3,0.2; -0.3,0.2; -0.3,-0.2; 0.3,-0.2";
  robot.max_v = 0.7;
  robot.max_w = 2;
  write_robot(config, robot, 0.1);
  const double degrees = 2 * 180 / 3.14159265358979323846;
  const std::string flat = "CReactiveNavigationSystem", tall = flat + "3D";
  EXPECT_NEAR(config.read_double("CAbstractPTGBasedReactive", "robotMax_V_mps", 0), 0.7, 1e-9);
  EXPECT_NEAR(config.read_double("CAbstractPTGBasedReactive", "robotMax_W_degps", 0), degrees,
              1e-3);
  EXPECT_NEAR(config.read_double(flat, "PTG0_v_max_mps", 0), 0.7, 1e-9);
  EXPECT_NEAR(config.read_double(tall, "PTG1_w_max_dps", 0), degrees, 1e-3);
  EXPECT_FALSE(config.keyExists(flat, "PTG1_v_max_mps"));  // only where the file has such a key
  const double radius = std::hypot(0.3, 0.2) + 0.1;
  EXPECT_NEAR(config.read_double(flat, "RobotModel_circular_shape_radius", 0), radius, 1e-6);
  std::vector<double> xs;
  config.read_vector(flat, "RobotModel_shape2D_xs", {}, xs);
  ASSERT_EQ(xs.size(), 4U);
  EXPECT_NEAR(std::abs(xs[0]), 0.4, 1e-9);
  config.read_vector(tall, "LEVEL1_VECTORY", {}, xs);
  ASSERT_EQ(xs.size(), 4U);
  EXPECT_NEAR(std::abs(xs[0]), 0.3, 1e-9);
}

}  // namespace
}  // namespace slalom
