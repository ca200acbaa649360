// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/plot_data.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

std::vector<std::string> labels(const PlotAxis& axis, int max_steps) {
  std::vector<std::string> all;
  for (const auto& tick : axis.ticks(max_steps)) all.push_back(tick.label);
  return all;
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_step(0, 1, 10).size(), 0.1);
  EXPECT_DOUBLE_EQ(round_step(0, 1, 9).size(), 0.2);
  EXPECT_DOUBLE_EQ(round_step(0, 1, 4).size(), 0.5);
  EXPECT_DOUBLE_EQ(round_step(-300, 900, 3).size(), 500);
  EXPECT_DOUBLE_EQ(round_step(0, 1, 1).size(), 1);
}

TEST(RoundStep, HasCorrectlyRoundedMultiples) {
  const RoundStep tenth = round_step(0, 1, 10);
  EXPECT_EQ(tenth.times(3), 0.3);  // 3 * 0.1 is not
  EXPECT_EQ(tenth.label(tenth.times(3)), "0.3");
  EXPECT_EQ(tenth.label(1), "1.0");
}

TEST(RoundStep, HandlesEmptyAndExtremeRanges) {
  EXPECT_DOUBLE_EQ(round_step(0, 0, 5).size(), 1);
  EXPECT_DOUBLE_EQ(round_step(20, 20, 5).size(), 2);
  const double huge = std::numeric_limits<double>::max();
  EXPECT_TRUE(std::isfinite(round_step(-huge, huge, 5).size()));
  EXPECT_GT(round_step(0, std::numeric_limits<double>::denorm_min(), 5).size(), 0);
  // Steps below the precision of doubles near 1e16 would never reach the end of the range.
  EXPECT_GE(round_step(1e16, 1e16 + 4, 100).size(), 2);
}

TEST(PlotAxis, ConvertsValuesToPixelsAndBack) {
  const PlotAxis down(10, 20, 300, 100);  // y axis: larger values further up
  EXPECT_DOUBLE_EQ(down.to_pixel(10), 300);
  EXPECT_DOUBLE_EQ(down.to_pixel(12.5), 250);
  EXPECT_DOUBLE_EQ(down.to_value(100), 20);
}

TEST(PlotAxis, WidensAnEmptyRangeAroundItsValue) {
  const PlotAxis axis(5, 5, 0, 100);
  EXPECT_DOUBLE_EQ(axis.to_pixel(5), 50);
  EXPECT_DOUBLE_EQ(PlotAxis(0, 0, 0, 100).to_pixel(0), 50);
}

TEST(PlotAxis, HasRoundTicksWithinItsRange) {
  EXPECT_EQ(labels(PlotAxis(0, 1, 0, 100), 5),
            (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(PlotAxis(-7, 12, 0, 100), 4), (std::vector<std::string>{"-5", "0", "5", "10"}));
}

}  // namespace
}  // namespace slalom
