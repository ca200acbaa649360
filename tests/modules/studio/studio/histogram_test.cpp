// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/plot_data.h>

#include <gtest/gtest.h>

#include <limits>

namespace slalom {
namespace {

ListColumn column_of(const std::vector<std::optional<Value>>& values) {
  ListColumn column({"density", 1, "Density", "-", Direction::None});
  for (const auto& value : values) column.add(value);
  return column;
}

ListColumn column_of_numbers(const std::vector<double>& numbers) {
  std::vector<std::optional<Value>> values;
  for (const double number : numbers) values.push_back(Value::of(number));
  return column_of(values);
}

TEST(Histogram, CountsEachValueInItsBar) {
  // Range 0.05 to 0.42, at most 5 parts: steps of 0.1.
  const Histogram histogram =
      make_histogram(column_of_numbers({0.05, 0.3, 0.2999, 0.42, 0.1, 0.15}), 5);
  ASSERT_EQ(histogram.bars.size(), 5);
  const std::vector<std::size_t> expected = {1, 2, 1, 1, 1};  // 0.3 lies in [0.3, 0.4)
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(histogram.bars[i].count, expected[i]) << i;
  EXPECT_EQ(histogram.bars[1].label, "[0.1, 0.2)");
  EXPECT_EQ(histogram.bars[2].high, 0.3);
  EXPECT_EQ(histogram.max_count(), 2);
}

TEST(Histogram, FindsTheBarOfAValue) {
  const Histogram histogram = make_histogram(column_of_numbers({0, 10}), 5);
  EXPECT_EQ(histogram.bar_of(0), 0);
  EXPECT_EQ(histogram.bar_of(1.999), 0);
  EXPECT_EQ(histogram.bar_of(2), 1);
  EXPECT_EQ(histogram.bar_of(10), 5);
  EXPECT_FALSE(histogram.bar_of(12));
  EXPECT_FALSE(histogram.bar_of(-0.001));
  EXPECT_FALSE(histogram.bar_of(std::numeric_limits<double>::quiet_NaN()));
}

TEST(Histogram, CountsScenariosWithoutNumbers) {
  const Histogram histogram =
      make_histogram(column_of({Value::of(1), std::nullopt, Value::na("no path"), std::nullopt}));
  EXPECT_EQ(histogram.na, 1);
  EXPECT_EQ(histogram.not_computed, 2);
  ASSERT_EQ(histogram.bars.size(), 1);
  EXPECT_EQ(histogram.bars[0].count, 1);
}

TEST(Histogram, HasNoBarsWithoutNumbers) {
  const Histogram histogram = make_histogram(column_of({Value::na("no path")}));
  EXPECT_TRUE(histogram.bars.empty());
  EXPECT_EQ(histogram.max_count(), 0);
  EXPECT_FALSE(histogram.bar_of(0));
}

TEST(Histogram, HasIntegerEdgesForCounts) {
  const Histogram histogram = make_histogram(column_of_numbers({3, 4, 4, 6}));
  ASSERT_EQ(histogram.bars.size(), 4);
  EXPECT_EQ(histogram.bars[1].label, "[4, 5)");
  EXPECT_EQ(histogram.bars[1].count, 2);
}

TEST(Histogram, LosesNoValueOfAnyRange) {
  const double huge = std::numeric_limits<double>::max();
  for (const std::vector<double>& numbers : {std::vector<double>{-huge / 2, 0, huge / 2},
                                             {1e16, 1e16 + 2},
                                             {7.1, 7.1},
                                             {0, 5e-324},
                                             {-0.3, -0.1, 0.1}}) {
    const Histogram histogram = make_histogram(column_of_numbers(numbers));
    std::size_t counted = 0;
    for (const auto& bar : histogram.bars) counted += bar.count;
    EXPECT_EQ(counted, numbers.size()) << numbers.front();
    EXPECT_LE(histogram.bars.size(), 27);
  }
}

}  // namespace
}  // namespace slalom
