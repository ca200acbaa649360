// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(CellText, WritesASmallPValueAsABound) {
  EXPECT_EQ(p_text(0.01234), "p = 0.0123");
  EXPECT_EQ(p_text(0.0001), "p = 0.0001");
  EXPECT_EQ(p_text(0.00009999), "p < 0.0001");
  EXPECT_EQ(p_text(0), "p < 0.0001");
  EXPECT_EQ(p_number_text(1), "1.0000");
  EXPECT_EQ(p_number_text(1e-300), "< 0.0001");
}

TEST(CellText, ShowsThreeSignificantDigits) {
  Cell cell;
  const auto digits = [&](double estimate) {
    cell.estimate = estimate;
    return digits_for({&cell}, {});
  };
  EXPECT_EQ(digits(0.954), 3);
  EXPECT_EQ(digits(9.54), 2);
  EXPECT_EQ(digits(95.4), 1);
  EXPECT_EQ(digits(954), 0);
  EXPECT_EQ(digits(95400), 0);
  EXPECT_EQ(digits(0), 2);
  EXPECT_EQ(digits(1e-9), 4);
}

TEST(CellText, CallsOnlyAllRunsAHundredPercentAndOnlyNoneZero) {
  EXPECT_EQ(share_text(599.0 / 600), "99.8");
  EXPECT_EQ(share_text(1.0 / 20000), "0.01");
  EXPECT_EQ(share_text(0.871), "87");
  EXPECT_EQ(share_text(0), "0");
  EXPECT_EQ(share_text(1), "100");
  EXPECT_EQ(share_text(1 - 1e-15), "100");  // a mean of ones
}

TEST(CellText, ShowsSampleSizeAndDeviation) {
  Cell cell;
  cell.n = 60;
  cell.available = 56;
  cell.estimate = 0.75;
  cell.deviation = 0.051;
  cell.interval = Interval{0.7, 0.8};
  EXPECT_EQ(estimate_text(cell, 2) + " " + interval_text(cell, 2), "0.75 [0.70, 0.80]");
  EXPECT_EQ(support_text(cell, {}, 2), "±0.05 n = 56 of 60");
  EXPECT_EQ(support_text(cell, {success_info()}, 2), "42/56 NA=4");
  EXPECT_EQ(estimate_text({}, 2), "-");
  EXPECT_EQ(interval_text({}, 2), "");
}

TEST(CellText, CountsCharactersNotBytes) {
  EXPECT_EQ(display_width("±0.05"), 5u);
  EXPECT_EQ(pad_left("±1", 4), "  ±1");
  EXPECT_EQ(pad_right("±1", 4), "±1  ");
  EXPECT_EQ(pad_left("long", 2), "long");
}

}  // namespace
}  // namespace slalom
