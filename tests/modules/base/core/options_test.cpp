// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/options.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

enum class Shape { Disc, Polygon };
constexpr auto enum_names(Shape) {
  return std::array{"disc", "polygon"};
}

struct Sample {
  double radius = 0.25;
  int rays = 181;
  bool forward = true;
  std::uint64_t seed = 1;
  Shape kind = Shape::Disc;
  std::optional<Shape> drawn;
  std::optional<double> limit;
  void visit(OptionVisitor& v) {
    v.option("radius", radius, "m", "radius of the robot", Range::positive());
    v.option("rays", rays, "-", "rays of a scan", Range::between(2, 1000));
    v.option("forward", forward, "forward only");
    v.option("seed", seed, "seed of the noise");
    v.option("kind", kind, "kind of footprint");
    v.option("drawn", drawn, "as which it is drawn", "as_is");
    v.option("limit", limit, "s", "time of a run", Range::positive(), "auto");
  }
};

/// Whether the line `KEY = VALUE` is refused at its key with these words.
testing::AssertionResult refused(const std::string& key, const std::string& value,
                                 std::initializer_list<std::string> words) {
  const std::string text = "[s]\n" + key + " = " + value + "\n";
  return throws_error(ErrorKind::Usage, "f.ini:2: [s] " + key + ": ", words,
                      [&] { read_options<Sample>(IniFile::from_text(text, "f.ini"), "s"); });
}

TEST(Options, AbsentKeysKeepTheirDefaults) {
  const auto options = read_options<Sample>(IniFile::from_text("[s]\nrays = 7\n"), "s");
  EXPECT_EQ(options.rays, 7);
  EXPECT_EQ(options.radius, 0.25);
  EXPECT_TRUE(options.forward);
  EXPECT_EQ(options.kind, Shape::Disc);
  EXPECT_FALSE(options.drawn);
}

TEST(Options, EveryTypeIsRead) {
  const auto options = read_options<Sample>(
      IniFile::from_text("[s]\nradius = 1e-1\nforward = off\nkind = polygon\ndrawn = disc\n"), "s");
  EXPECT_EQ(options.radius, 0.1);
  EXPECT_FALSE(options.forward);
  EXPECT_EQ(options.kind, Shape::Polygon);
  EXPECT_EQ(options.drawn, Shape::Disc);
}

TEST(Options, InvalidValuesAreRefusedWithTheirKeyAndRange) {
  EXPECT_TRUE(refused("radius", "30cm", {"'30cm'", "expected a number > 0, in m"}));
  EXPECT_TRUE(refused("radius", "0", {"'0'", "expected a number > 0"}));
  EXPECT_TRUE(refused("radius", "nan", {"'nan'", "expected a number > 0"}));
  EXPECT_TRUE(refused("rays", "2.5", {"'2.5'", "expected an integer in [2, 1000]"}));
  EXPECT_TRUE(refused("forward", "maybe", {"'maybe'", "expected true or false"}));
  EXPECT_TRUE(refused("kind", "cube", {"'cube'", "expected one of disc, polygon"}));
  EXPECT_TRUE(refused("drawn", "cube", {"'cube'", "expected one of as_is, disc, polygon"}));
}

TEST(Options, ANumberWithAWordForNoneIsEither) {
  const auto read = [](const std::string& text) {
    return read_options<Sample>(IniFile::from_text("[s]\nlimit = " + text + "\n"), "s").limit;
  };
  EXPECT_EQ(read("2.5"), 2.5);
  EXPECT_EQ(read("auto"), std::nullopt);
  for (const char* value : {"soon", "0", "-1", "nan", "inf", "Auto", "autos"})
    EXPECT_TRUE(refused("limit", value,
                        {"'" + std::string(value) + "'", "expected a number > 0, or auto, in s"}));
  Sample options;
  for (const std::optional<double> limit : {std::optional<double>(), std::optional<double>(0.1)}) {
    options.limit = limit;
    IniFile ini;
    write_options(ini, "s", options, "Options ");
    EXPECT_EQ(read_options<Sample>(ini, "s").limit, limit);
    EXPECT_NO_THROW(check_options(options, location_of("run")));
  }
  options.limit = -1;
  EXPECT_THROW(check_options(options, location_of("run")), Error);
}

TEST(Options, UnknownKeysAreRefusedWithTheNearestName) {
  EXPECT_TRUE(refused("radus", "1", {"unknown", "expected 'radius'"}));
}

TEST(Options, AreWrittenAsTheyAreRead) {
  Sample sample;
  sample.radius = 0.1 + 0.2;
  sample.rays = 5;
  sample.forward = false;
  sample.kind = Shape::Polygon;
  IniFile ini;
  write_options(ini, "s", sample, "Options ");
  const auto copy = read_options<Sample>(ini, "s");
  EXPECT_EQ(copy.radius, sample.radius);
  EXPECT_EQ(copy.rays, 5);
  EXPECT_FALSE(copy.forward);
  EXPECT_EQ(copy.kind, Shape::Polygon);
  EXPECT_EQ(ini.where("s", "rays"), "Options s.rays");
}

TEST(Options, OfAProgramAreCheckedLikeThoseOfAFile) {
  Sample sample;
  const auto refused = [](const Sample& options, const std::string& where,
                          std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words,
                        [&] { check_options(options, location_of("robot")); });
  };
  EXPECT_NO_THROW(check_options(sample, location_of("robot")));
  sample.radius = 0;
  EXPECT_TRUE(refused(sample, "robot.radius: ", {"'0'", "expected a number > 0"}));
  sample.radius = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(refused(sample, "robot.radius: ", {"'inf'", "expected a number > 0"}));
  sample.radius = 1;
  sample.rays = 1;
  EXPECT_TRUE(refused(sample, "robot.rays: ", {"'1'", "expected an integer in [2, 1000]"}));
  sample.rays = 2;
  sample.seed = 1ULL << 63;
  EXPECT_TRUE(refused(sample, "robot.seed: ", {"'9223372036854775808'", "an integer in [0, "}));
}

TEST(OptionLocation, NamesTheLineOfAnIniOrTheFunctionOfAnOption) {
  const IniFile ini = IniFile::from_text("[method.a]\nclass = X\n", "campaign.ini");
  const OptionLocation in_file = location_in(ini, "method.a");
  EXPECT_EQ(in_file("class"), "campaign.ini:2: [method.a] class");
  EXPECT_EQ(in_file(""), "campaign.ini:1: [method.a]");
  const OptionLocation in_program = location_of("mrpt_holonomic");
  EXPECT_EQ(in_program("class"), "mrpt_holonomic.class");
  EXPECT_EQ(in_program(""), "mrpt_holonomic");
}

TEST(Options, TheListerShowsDefaultUnitRangeAndHelp) {
  OptionLister lister;
  Sample().visit(lister);
  EXPECT_NE(lister.text().find("radius = 0.25 m"), std::string::npos);
  EXPECT_NE(lister.text().find("radius of the robot (> 0)"), std::string::npos);
  EXPECT_NE(lister.text().find("kind = disc "), std::string::npos);
  EXPECT_NE(lister.text().find("kind of footprint (disc | polygon)"), std::string::npos);
  EXPECT_NE(lister.text().find("drawn = as_is "), std::string::npos);
  EXPECT_NE(lister.text().find("(as_is | disc | polygon)"), std::string::npos);
  EXPECT_NE(lister.text().find("limit = auto s "), std::string::npos) << lister.text();
  EXPECT_NE(lister.text().find("time of a run (> 0, or auto)"), std::string::npos);
}

struct Seeded {
  std::uint64_t seed = 1;
  void visit(OptionVisitor& v) { v.option("seed", seed, "a seed"); }
};

TEST(Options, SeedsHaveSixtyThreeBits) {
  const auto read = [](const std::string& text) {
    return read_options<Seeded>(IniFile::from_text("[s]\nseed = " + text + "\n"), "s").seed;
  };
  EXPECT_EQ(read("9223372036854775807"), 9223372036854775807U);
  EXPECT_THROW(read("9223372036854775808"), Error);
  EXPECT_THROW(read("-1"), Error);
  EXPECT_THROW(read("1.5"), Error);
  OptionLister lister;
  Seeded().visit(lister);
  EXPECT_NE(lister.text().find("a seed (in [0, 9223372036854775807])"), std::string::npos);
}

}  // namespace
}  // namespace slalom
