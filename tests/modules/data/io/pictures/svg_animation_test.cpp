// SPDX-License-Identifier: BSD-3-Clause
#include "io_sample.h"
#include "occurrences.h"

#include <slalom/io/svg_animation.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

Sample at(double t, double x, double y, double phi) {
  Sample sample;
  sample.t = t;
  sample.pose = {x, y, phi};
  return sample;
}

TEST(SvgAnimation, TheRobotIsAtEachSampleAtItsTimeAndThenPauses) {
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  const std::string svg =
      render_animated_svg(scenario, options, {{at(2, 1, 3, 0), at(3, 2, 3, 0), at(5, 4, 1, 0)}});
  // 3 s and a pause of 1 s: samples at 0, 1/4 and 3/4 of the repetition.
  EXPECT_EQ(count(svg, "dur=\"4.000s\""), 2U);
  EXPECT_EQ(count(svg, "keyTimes=\"0.000000;0.250000;0.750000;1\""), 2U);
  EXPECT_EQ(count(svg, "values=\"50.0 50.0;100.0 50.0;200.0 150.0;200.0 150.0\""), 1U);
  EXPECT_EQ(svg.compare(svg.size() - 6, 6, "</svg>"), 0);
}

TEST(SvgAnimation, MoversAreWhereTheyAreAtEachSampleWhileTheyArePresent) {
  const Mover mover = {"m", 0.5, {{1, {2, 2}}, {3, {4, 2}}}, MoverEnd::Vanish};
  const Scenario scenario =
      Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3}).with_movers({mover});
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  const std::string svg = render_animated_svg(
      scenario, options, {{at(5, 1, 3, 0), at(6, 2, 3, 0), at(7, 2, 3, 0), at(9, 4, 1, 0)}});
  // The samples are at 0, 1, 2 and 4 s of the run, when the mover is not yet and no longer present.
  EXPECT_EQ(count(svg, "values=\"100.0 100.0;100.0 100.0;150.0 100.0;200.0 100.0;200.0 100.0\""),
            1U)
      << svg;
  EXPECT_EQ(count(svg, "values=\"hidden;visible;visible;hidden;hidden\""), 1U);
  EXPECT_EQ(count(svg, "class=\"moving\" r=\"25.0\""), 1U);
  EXPECT_EQ(count(svg, "<circle class=\"mover\""), 0U);
  EXPECT_EQ(count(svg, "<polyline class=\"mover\""), 1U);
}

TEST(SvgAnimation, PeopleMoveAsTheRecordSays) {
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3})
                                .with_people({{"p", 0.5, 1, {2, 2}, {{7, 1}}}});
  const Movers record = {{"p", 0.5, {{0, {2, 2}}, {2, {4, 2}}}}};
  SceneOptions options;
  options.max_pixels = 400;  // 50 pixels per meter
  options.movers = &record;
  const Trajectory run = {{at(5, 1, 3, 0), at(6, 2, 3, 0), at(7, 2, 3, 0)}};
  const std::string svg = render_animated_svg(scenario, options, run);
  EXPECT_EQ(count(svg, "values=\"100.0 100.0;150.0 100.0;200.0 100.0;200.0 100.0\""), 1U) << svg;
  EXPECT_EQ(count(svg, "<title>person p</title>"), 2U);  // of the path and of the disc
  EXPECT_EQ(count(svg, "class=\"moving\" r=\"25.0\""), 1U);
}

TEST(SvgAnimation, HeadingsDoNotJumpByATurn) {
  const Scenario scenario = Scenario::continuous("s", {0, 0, 8, 4}, {}, {1, 3, 0}, {7, 3});
  const double pi = 3.14159265358979323846;
  const std::string svg = render_animated_svg(
      scenario, {}, {{at(0, 1, 1, 0.75 * pi), at(1, 1, 1, pi), at(2, 1, 1, -0.75 * pi)}});
  EXPECT_EQ(count(svg, "values=\"-135.0;-180.0;-225.0;-225.0\""), 1U) << svg;  // y points down
}

TEST(SvgAnimation, WithoutMotionItIsThePicture) {
  const Scenario scenario = sample_scenario(1, "s");
  EXPECT_EQ(render_animated_svg(scenario, {}, {}), render_svg(scenario, {}));
}

}  // namespace
}  // namespace slalom
