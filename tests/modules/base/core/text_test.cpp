// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Text, SplitTrimsPartsAndKeepsEmptyOnes) {
  EXPECT_EQ(split(" a, b ,,c", ','), (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_TRUE(split("  ", ',').empty());
  EXPECT_EQ(split_nonempty(" a, b ,,c", ','), (std::vector<std::string>{"a", "b", "c"}));
}

TEST(Text, LowerCaseChangesLettersOfAsciiOnly) {
  EXPECT_EQ(lower_case("Map_2.YAML"), "map_2.yaml");
  EXPECT_EQ(lower_case("\xC3\x84"), "\xC3\x84");
}

TEST(Text, EndsWithComparesCompleteEndings) {
  EXPECT_TRUE(ends_with("map.yaml", ".yaml"));
  EXPECT_TRUE(ends_with("map", ""));
  EXPECT_FALSE(ends_with("map.yml", ".yaml"));
  EXPECT_FALSE(ends_with("aml", ".yaml"));
}

TEST(Text, JoinIsTheInverseOfSplit) {
  EXPECT_EQ(join({"a", "b"}, ", "), "a, b");
  EXPECT_EQ(join({}, ", "), "");
}

TEST(Text, StartsAndEndsWithItselfAndTheEmptyText) {
  EXPECT_TRUE(starts_with("map.yaml", "map"));
  EXPECT_TRUE(ends_with("map.yaml", ".yaml"));
  for (const std::string part : {"", "map.yaml"}) {
    EXPECT_TRUE(starts_with("map.yaml", part));
    EXPECT_TRUE(ends_with("map.yaml", part));
  }
  for (const std::string other : {"yaml", "a map.yaml", "map.yaml.gz"})
    EXPECT_FALSE(starts_with("map.yaml", other)) << other;
  for (const std::string other : {"map", "a map.yaml", "map.yaml.gz"})
    EXPECT_FALSE(ends_with("map.yaml", other)) << other;
}

TEST(NearestName, IsEmptyWhenNoCandidateIsClose) {
  EXPECT_EQ(nearest_name("radus", {"radius", "max_v"}), "radius");
  EXPECT_EQ(nearest_name("zzzz", {"radius", "max_v"}), "");
  EXPECT_EQ(nearest_name("z", {"t", "vy"}), "") << "they have no letter in common";
  EXPECT_EQ(nearest_name("y", {"t", "vy"}), "vy");
}

TEST(ExpectedName, IsTheNearestElseAllElseTheGivenText) {
  EXPECT_EQ(expected_name("radus", {"radius", "max_v"}), "'radius'");
  EXPECT_EQ(expected_name("zzzz", {"radius", "max_v"}), "one of radius, max_v");
  EXPECT_EQ(expected_name("zzzz", {}, "a name; there are none"), "a name; there are none");
}

TEST(Text, FormattedNumbersReadBackExactly) {
  RandomEngine engine(3);
  for (int i = 0; i < 1000; ++i) {
    const double number = normal(engine, 0, 1) * std::pow(10, uniform_int(engine, -12, 12));
    double back = 0;
    ASSERT_TRUE(parse_number(format_number(number), back));
    EXPECT_EQ(back, number);
  }
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(-0.0), format_number(0.0));
  EXPECT_EQ(format_fixed(1.005, 2), "1.00");
}

TEST(Text, OnlyCompleteFiniteNumbersAreParsed) {
  double number = 0;
  EXPECT_TRUE(parse_number(" +1.5 ", number));
  EXPECT_EQ(number, 1.5);
  for (const char* bad : {"", "x", "1.5x", "1,5", "inf", "nan", "0x10", "--1"})
    EXPECT_FALSE(parse_number(bad, number)) << bad;
  long long integer = 0;
  EXPECT_TRUE(parse_integer("-12", integer));
  EXPECT_EQ(integer, -12);
  EXPECT_FALSE(parse_integer("1.0", integer));
  EXPECT_FALSE(parse_integer("99999999999999999999", integer));
}

}  // namespace
}  // namespace slalom
