// SPDX-License-Identifier: BSD-3-Clause
#include "common/parameters.h"

#include <gtest/gtest.h>

namespace reactive {
namespace {

struct Numbers {
  double a = 1;
  int b = 2;
  PathMap map = PathMap::Sensed;
  void visit(slalom::OptionVisitor& v) {
    v.option("a", a, "m", "a length", slalom::Range::at_least(0));
    v.option("b", b, "-", "a count", slalom::Range::between(1, 3));
    v.option("map", map, "a map");
  }
};

std::string refusal(const std::string& key, const std::string& text) {
  Numbers numbers;
  try {
    set_parameter(numbers, key, text);
  } catch (const slalom::Error& e) {
    EXPECT_EQ(numbers.a, 1);
    EXPECT_EQ(numbers.b, 2);
    return e.what();
  }
  return "";
}

TEST(SetParameter, SetsTheOneWithTheKey) {
  Numbers numbers;
  set_parameter(numbers, "a", "2.5");
  set_parameter(numbers, "map", "known");
  EXPECT_EQ(numbers.a, 2.5);
  EXPECT_EQ(numbers.b, 2);
  EXPECT_EQ(numbers.map, PathMap::Known);
}

TEST(SetParameter, RefusesUnknownKeysAndInvalidValues) {
  EXPECT_EQ(refusal("a", "-1"), "a: '-1' is not valid; expected a number >= 0, in m");
  EXPECT_EQ(refusal("b", "4"), "b: '4' is not valid; expected an integer in [1, 3]");
  EXPECT_EQ(refusal("map", "guessed"),
            "map: 'guessed' is not valid; expected one of sensed, known");
  for (const char* text : {"nan", "inf", "1x", "", "x"}) EXPECT_NE(refusal("a", text), "") << text;
  EXPECT_EQ(refusal("c", "1"), "c: unknown parameter");
}

}  // namespace
}  // namespace reactive
