#include <slalom/core/error.h>
#include <slalom/core/options.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

struct Sample {
  double radius = 0.25;
  int rays = 181;
  bool forward = true;
  std::string kind = "disc";
  void visit(OptionVisitor& v) {
    v.option("radius", radius, "m", "radius of the robot", Range::positive());
    v.option("rays", rays, "-", "rays of a scan", Range::between(2, 1000));
    v.option("forward", forward, "forward only");
    v.option("kind", kind, "kind of footprint", {"disc", "polygon"});
  }
};

std::string message_for(const std::string& text) {
  try {
    read_options<Sample>(IniFile::from_text("[s]\n" + text + "\n", "f.ini"), "s");
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(Options, AbsentKeysKeepTheirDefaults) {
  const auto options = read_options<Sample>(IniFile::from_text("[s]\nrays = 7\n"), "s");
  EXPECT_EQ(options.rays, 7);
  EXPECT_EQ(options.radius, 0.25);
  EXPECT_TRUE(options.forward);
}

TEST(Options, EveryTypeIsRead) {
  const auto options = read_options<Sample>(
      IniFile::from_text("[s]\nradius = 1e-1\nforward = off\nkind = polygon\n"), "s");
  EXPECT_EQ(options.radius, 0.1);
  EXPECT_FALSE(options.forward);
  EXPECT_EQ(options.kind, "polygon");
}

TEST(Options, BadValuesAreRefusedWithPlaceAndExpectation) {
  EXPECT_EQ(message_for("radius = 0"),
            "f.ini:2: [s] radius: '0' is not valid; expected a number > 0");
  EXPECT_EQ(message_for("radius = nan"),
            "f.ini:2: [s] radius: 'nan' is not valid; expected a number > 0");
  EXPECT_EQ(message_for("rays = 2.5"),
            "f.ini:2: [s] rays: '2.5' is not valid; expected a whole number in [2, 1000]");
  EXPECT_EQ(message_for("forward = maybe"),
            "f.ini:2: [s] forward: 'maybe' is not valid; expected true or false");
  EXPECT_EQ(message_for("kind = cube"),
            "f.ini:2: [s] kind: 'cube' is not valid; expected one of disc, polygon");
}

TEST(Options, UnknownKeysAreRefusedWithTheNearestName) {
  EXPECT_EQ(message_for("radus = 1"), "f.ini:2: [s] radus: unknown key; expected 'radius'");
}

TEST(Options, TheListerShowsDefaultUnitRangeAndHelp) {
  OptionLister lister;
  Sample().visit(lister);
  EXPECT_NE(lister.text().find("radius = 0.25 m"), std::string::npos);
  EXPECT_NE(lister.text().find("radius of the robot (> 0)"), std::string::npos);
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
