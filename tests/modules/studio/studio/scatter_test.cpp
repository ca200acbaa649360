// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/plot_data.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

ListColumn column_of_values(const std::vector<std::optional<Value>>& values) {
  ListColumn column;
  for (const auto& value : values) column.add(value);
  return column;
}

/// Points (1, 10), (2, 20), (3, 15) at rows 0, 1, 4 of a list.
Scatter three_points() {
  return {column_of_values({Value::of(1), Value::of(2), Value::of(9), std::nullopt, Value::of(3)}),
          column_of_values(
              {Value::of(10), Value::of(20), Value::na("no path"), Value::of(1), Value::of(15)})};
}

const PlotAxis kX(0, 4, 0, 40), kY(0, 20, 40, 0);  // 10 and 2 pixels a unit

TEST(Scatter, SkipsScenariosWithoutBothNumbers) {
  const Scatter scatter = three_points();
  ASSERT_EQ(scatter.points().size(), 3);
  EXPECT_EQ(scatter.skipped(), 2);
  EXPECT_EQ(scatter.points()[2].row, 4);
  EXPECT_EQ(scatter.x_range(), std::make_pair(1.0, 3.0));
  EXPECT_EQ(scatter.y_range(), std::make_pair(10.0, 20.0));
  EXPECT_FALSE(Scatter().x_range());
}

TEST(Scatter, FindsThePointsInARectangle) {
  const Scatter scatter = three_points();
  const std::vector<std::size_t> right = {1, 4};
  EXPECT_EQ(scatter.within(2, 15, 3, 20), right);  // both lie on its border
  EXPECT_EQ(scatter.within(3, 20, 2, 15), right);
  EXPECT_TRUE(scatter.within(2.1, 0, 2.9, 100).empty());
}

TEST(Scatter, FindsThePointUnderTheMouse) {
  const Scatter scatter = three_points();  // at pixels (10, 20), (20, 0), (30, 10)
  EXPECT_EQ(scatter.nearest(kX, kY, 28, 9, 5), 4);
  EXPECT_EQ(scatter.nearest(kX, kY, 13, 16, 5), 0);  // 5 pixels away
  EXPECT_FALSE(scatter.nearest(kX, kY, 13, 15, 5));
}

TEST(Scatter, DrawsADotAroundEachPointAndClipsIt) {
  const auto picture = draw_dots(three_points(), kX, kY, 0, 0, 40, 40, {0x10, 0x80, 0xff, 0xff});
  ASSERT_EQ(picture.size(), 4 * 40 * 40);
  const auto alpha = [&](std::size_t x, std::size_t y) { return picture[4 * (40 * y + x) + 3]; };
  EXPECT_EQ(picture[2], 0xff);
  EXPECT_EQ(alpha(10, 20), 217);  // 0.85 * 255
  EXPECT_EQ(alpha(12, 21), 217);  // at the rim
  EXPECT_EQ(alpha(13, 20), 0);
  EXPECT_EQ(alpha(20, 0), 217);  // half of this dot is above the picture
  EXPECT_EQ(alpha(20, 39), 0);
}

TEST(Scatter, IsMoreOpaqueWhereDotsOverlap) {
  const ListColumn x = column_of_values({Value::of(1), Value::of(1)});
  const auto picture = draw_dots(Scatter(x, x), kX, kY, 0, 0, 40, 40, {0x10, 0x80, 0xff, 0xff});
  EXPECT_EQ(picture[4 * (40 * 38 + 10) + 3], 249);  // (1 - 0.15^2) * 255
}

}  // namespace
}  // namespace slalom
