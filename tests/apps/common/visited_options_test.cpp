// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/app/visited_options.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

enum class Color { Red, LightBlue };
constexpr auto enum_names(Color) {
  return std::array{"red", "light_blue"};
}

struct Paint {
  int max_layers = 2;
  double width = HUGE_VAL;
  bool is_matt = false;
  Color color = Color::Red;
  std::string name = "wall";

  void visit(OptionVisitor& v) {
    v.option("max_layers", max_layers, "-", "layers of paint", Range::between(1, 9));
    v.option("width", width, "m", "width of the brush", Range::positive());
    v.option("is_matt", is_matt, "without gloss");
    v.option("color", color, "color of the paint");
    v.option("name", name, "what is painted");
  }
};

class VisitedOptions : public testing::Test {
 protected:
  void SetUp() override { add_options_of(app_, paint_); }
  void parse(const std::string& line) { app_.parse(line, false); }

  Paint paint_;
  CLI::App app_;
};

TEST_F(VisitedOptions, SetTheValuesOfTheStruct) {
  parse("--max-layers 3 --width 0.2 --is-matt --color light_blue --name 'the door'");
  EXPECT_EQ(paint_.max_layers, 3);
  EXPECT_EQ(paint_.width, 0.2);
  EXPECT_TRUE(paint_.is_matt);
  EXPECT_EQ(paint_.color, Color::LightBlue);
  EXPECT_EQ(paint_.name, "the door");
}

TEST_F(VisitedOptions, KeepTheDefaultsOfThoseThatAreNotGiven) {
  parse("--max-layers 3");
  EXPECT_FALSE(paint_.is_matt);
  EXPECT_EQ(paint_.color, Color::Red);
  EXPECT_EQ(paint_.name, "wall");
}

TEST_F(VisitedOptions, RefuseWhatIsOutOfRangeAsAnIniDoes) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--max-layers", {"'10'", "an integer in [1, 9]"},
                           [&] { parse("--max-layers 10"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--width", {"'wide'", "a number > 0, in m"},
                           [&] { parse("--width wide"); }));
  EXPECT_THROW(parse("--color green"), CLI::ParseError);
}

TEST_F(VisitedOptions, ShowRangeDefaultAndUnitInTheHelp) {
  const std::string help = app_.help();
  for (const char* text : {"--max-layers INT=2", "Layers of paint (in [1, 9])", "--width FLOAT ",
                           "Width of the brush, m (> 0)", "{red,light_blue}=red", "=wall"})
    EXPECT_NE(help.find(text), std::string::npos) << text << " in\n" << help;
  EXPECT_EQ(help.find("inf"), std::string::npos) << help;
}

}  // namespace
}  // namespace slalom
