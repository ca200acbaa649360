// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/range.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(RangeNotation, IsReadBack) {
  for (const Range& range : {Range::any(), Range::at_least(0), Range::at_most(-1.5),
                             Range::between(0, 1.0 / 3), Range::between(2, 2)}) {
    const auto read = parse_range(range_notation(range));
    ASSERT_TRUE(read) << range_notation(range);
    EXPECT_EQ(read->low, range.low);
    EXPECT_EQ(read->high, range.high);
  }
  EXPECT_EQ(range_notation(Range::between(-0.5, 1e20)), "-0.5..1e+20");
  EXPECT_EQ(range_notation(Range::at_most(1)), "..1");
  EXPECT_EQ(range_notation(Range::any()), "..");
}

TEST(RangeNotation, IsRefusedIfItIsMalformedOrEmpty) {
  for (const char* text :
       {"", ".", "1", "0,1", "a..1", "0..b", "1..0", "nan..1", "0..nan", "0..1 m"})
    EXPECT_FALSE(parse_range(text)) << text;
}

TEST(RangeBounds, AreTheFiniteOnes) {
  EXPECT_TRUE(Range::between(0, 1).is_bounded());
  EXPECT_FALSE(Range::at_least(0).is_bounded());
  EXPECT_TRUE(Range::at_least(0).bounded_below());
  EXPECT_FALSE(Range::at_most(0).bounded_below());
  EXPECT_TRUE(Range::at_most(0).bounded_above());
}

}  // namespace
}  // namespace slalom
