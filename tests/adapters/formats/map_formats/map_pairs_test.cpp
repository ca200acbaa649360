// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/map_formats/map_pairs.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using Start = std::optional<mrpt::math::TPose2D>;

const Start kStart = mrpt::math::TPose2D(1, 2, 0.5);

testing::AssertionResult refused(const std::string& text, const std::string& where,
                                 std::initializer_list<std::string> words,
                                 const Start& start = std::nullopt) {
  return throws_error(ErrorKind::File, where, words,
                      [&] { parse_map_pairs(text, "pairs", start); });
}

TEST(MapPairs, AreLinesOfAStartAndAGoalWithOrWithoutHeading) {
  const auto pairs = parse_map_pairs("x,y,phi,gx,gy\n# a remark\n1,2,0.5,3,4\n\n5;6;0;7;8;1.5\n",
                                     "pairs", std::nullopt);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].line, 3U);
  EXPECT_EQ(pairs[0].start, *kStart);
  EXPECT_EQ(pairs[0].goal, mrpt::math::TPoint2D(3, 4));
  EXPECT_FALSE(pairs[0].goal_heading);
  EXPECT_EQ(pairs[1].line, 5U);
  EXPECT_EQ(pairs[1].goal_heading, 1.5);
}

TEST(MapPairs, AreGoalsFromOneStart) {
  const auto pairs = parse_map_pairs("3 4\n5\t6\t-1\n7 8 0 9 10\n", "pairs", kStart);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0].start, *kStart);
  EXPECT_EQ(pairs[1].start, *kStart);
  EXPECT_EQ(pairs[1].goal_heading, -1);
  EXPECT_EQ(pairs[2].start, mrpt::math::TPose2D(7, 8, 0)) << "that of the line itself";
}

TEST(MapPairs, AreRefusedWithTheLineThatIsNone) {
  EXPECT_TRUE(refused("1,2,0,3,4\n1,2,3,4\n", "pairs:2: ", {"no pair of start and goal"}));
  EXPECT_TRUE(refused("1,2,0,3,4\nx,y\n", "pairs:2: ", {"no pair of start and goal"}));
  EXPECT_TRUE(refused("1,2,0,3,inf\n2,3\n", "pairs:2: ", {"a goal without start", "--start"}));
  EXPECT_TRUE(refused("# nothing\nx,y\n", "pairs: ", {"has no pairs"}, kStart));
  EXPECT_TRUE(refused("", "pairs: ", {"has no pairs"}, kStart));
}

}  // namespace
}  // namespace slalom
