// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/plot_data.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

LineSeries series_of(std::vector<double> x, std::vector<double> y) {
  LineSeries series;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

TEST(LineSeries, InterpolatesBetweenItsSamples) {
  const LineSeries series = series_of({0, 2, 4}, {1, 5, 3});
  EXPECT_DOUBLE_EQ(*series.value_at(0.5), 2);
  EXPECT_DOUBLE_EQ(*series.value_at(4), 3);
  EXPECT_FALSE(series.value_at(-0.1));
  EXPECT_FALSE(series.value_at(4.1));
  EXPECT_FALSE(series_of({}, {}).value_at(0));
}

TEST(LineSeries, HasNoValueInAGap) {
  const LineSeries series = series_of({0, 1, 2, 3}, {1, 1, kGap, 1});
  EXPECT_FALSE(series.value_at(1.5));
  EXPECT_FALSE(series.value_at(2));
  EXPECT_DOUBLE_EQ(*series.value_at(3), 1);
}

TEST(LineSeries, ComputesTheRangeOfFiniteNumbers) {
  EXPECT_EQ(range_of({kGap, 3, -1, std::numeric_limits<double>::infinity()}),
            std::make_pair(-1.0, 3.0));
  EXPECT_FALSE(range_of({kGap}));
}

TEST(LineSeries, KeepsExtremesAndGapsWhenDownsampled) {
  // 1000 samples on 4 columns: at most 4 samples a column, and the gap.
  LineSeries series;
  for (int i = 0; i < 1000; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sin(0.1 * i));
  }
  series.y[300] = 7;
  series.y[600] = kGap;
  const auto kept = downsampled(series, 0, 1000, 4);
  EXPECT_LE(kept.size(), 4 * 4 + 1 + 4);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const std::size_t needed : {0, 300, 600, 999})
    EXPECT_NE(std::find(kept.begin(), kept.end(), needed), kept.end()) << needed;
}

TEST(LineSeries, KeepsSamplesThatAreMoreThanAPixelApart) {
  EXPECT_EQ(downsampled(series_of({0, 1, 2}, {5, 6, 4}), 0, 3, 300),
            (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace slalom
