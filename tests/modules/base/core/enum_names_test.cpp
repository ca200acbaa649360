// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/enum_names.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

enum class Color { Red, DarkBlue };
constexpr auto enum_names(Color) {
  return std::array{"red", "dark_blue"};
}

TEST(EnumNames, ValuesHaveTheNameAtTheirPosition) {
  EXPECT_EQ(to_string(Color::Red), "red");
  EXPECT_EQ(to_string(Color::DarkBlue), "dark_blue");
  EXPECT_EQ(names_of<Color>(), (std::vector<std::string>{"red", "dark_blue"}));
  EXPECT_EQ(enum_values<Color>(), (std::vector<Color>{Color::Red, Color::DarkBlue}));
}

TEST(EnumNames, ValuesAreFoundByTheirName) {
  EXPECT_EQ(from_name<Color>("dark_blue"), Color::DarkBlue);
  EXPECT_FALSE(from_name<Color>("blue"));
  EXPECT_FALSE(from_name<Color>("Red"));
}

TEST(EnumNames, AnUnknownNameInAFileIsAnErrorWithTheNames) {
  EXPECT_EQ(from_stored_name<Color>("color", "red"), Color::Red);
  EXPECT_TRUE(throws_error(ErrorKind::File,
                           "color: ", {"unknown color 'blue'", "expected one of red, dark_blue"},
                           [] { from_stored_name<Color>("color", "blue"); }));
}

}  // namespace
}  // namespace slalom
