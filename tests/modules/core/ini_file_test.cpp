#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>

#include <gtest/gtest.h>

#include <functional>

namespace slalom {
namespace {

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(IniFile, ReadsSectionsKeysAndComments) {
  const IniFile ini = IniFile::from_text(
      "# a comment\n[robot]\nradius = 0.3  # metres\nname = a;b\n; another\n[method.nd]\nclass = "
      "X\n");
  EXPECT_EQ(ini.get("robot", "radius"), "0.3");
  EXPECT_EQ(ini.get("robot", "name"), "a;b");
  EXPECT_EQ(ini.get("method.nd", "class"), "X");
  EXPECT_FALSE(ini.get("robot", "mass").has_value());
  EXPECT_EQ(ini.sections(), (std::vector<std::string>{"robot", "method.nd"}));
}

TEST(IniFile, ExpandsMrptDefinitions) {
  const IniFile ini = IniFile::from_text("@define R 0.3\n[robot]\nradius = ${R}\n");
  EXPECT_EQ(ini.get("robot", "radius"), "0.3");
}

TEST(IniFile, KnowsTheLineOfAKey) {
  const IniFile ini = IniFile::from_text("[a]\n\nx = 1\n", "f.ini");
  EXPECT_EQ(ini.where("a", "x"), "f.ini:3: [a] x");
  EXPECT_EQ(ini.where("a"), "f.ini:1: [a]");
}

TEST(IniFile, LinesAreCountedRightAfterADefinition) {
  const IniFile ini = IniFile::from_text("@define R 1\n[a]\nx = ${R}\n", "f.ini");
  EXPECT_EQ(ini.where("a", "x"), "f.ini:3: [a] x");
}

TEST(IniFile, MalformedLinesAreRefusedWithTheirPlace) {
  EXPECT_EQ(message_of([] { IniFile::from_text("[a\n", "f.ini"); }),
            "f.ini:1: '[a' is not closed; expected [section]");
  EXPECT_EQ(message_of([] { IniFile::from_text("[a]\nhello\n", "f.ini"); }),
            "f.ini:2: 'hello' is neither a section nor a key of one; expected [section] or key = "
            "value");
  EXPECT_EQ(message_of([] { IniFile::from_text("[a]\nx=1\nx=2\n", "f.ini"); }),
            "f.ini:3: [a] x: key given twice; expected it once");
}

TEST(IniFile, AMissingFileIsAFileError) {
  try {
    IniFile::load("/nonexistent/x.ini");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_status(), 3);
    EXPECT_NE(std::string(e.what()).find("/nonexistent/x.ini"), std::string::npos);
  }
}

TEST(IniFile, OverridesReplaceOrAddAKey) {
  IniFile ini = IniFile::from_text("[method.nd]\nclass = X\n");
  ini.override_key("method.nd.class=Y");
  ini.override_key("robot.radius = 0.4");
  EXPECT_EQ(ini.get("method.nd", "class"), "Y");
  EXPECT_EQ(ini.get("robot", "radius"), "0.4");
  EXPECT_NE(message_of([&] { ini.override_key("radius"); }).find("SECTION.KEY=VALUE"),
            std::string::npos);
}

TEST(IniFile, ARemovedKeyIsGone) {
  IniFile ini = IniFile::from_text("[a]\nx = 1\ny = 2\n");
  ini.remove("a", "x");
  ini.remove("b", "x");
  EXPECT_FALSE(ini.get("a", "x").has_value());
  EXPECT_EQ(ini.keys("a"), (std::vector<std::string>{"y"}));
}

TEST(IniFile, CanonicalTextDoesNotDependOnOrderAndReadsBack) {
  const IniFile a = IniFile::from_text("[b]\ny=2\nx=1\n[a]\nz=3\n");
  const IniFile b = IniFile::from_text("[a]\nz = 3\n[b]\nx = 1\ny = 2\n");
  EXPECT_EQ(a.canonical_text(), b.canonical_text());
  EXPECT_EQ(IniFile::from_text(a.canonical_text()).canonical_text(), a.canonical_text());
}

TEST(IniFile, UnknownSectionsAreRefusedWithTheNearestName) {
  const IniFile ini = IniFile::from_text("[robto]\nradius = 1\n", "f.ini");
  EXPECT_EQ(message_of([&] {
              ini.reject_unknown_sections({"robot", "method.*"});
            }),
            "f.ini:1: [robto]: unknown section; expected [robot]");
  IniFile::from_text("[method.x]\n").reject_unknown_sections({"method.*"});
}

TEST(NearestName, GivesNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("radus", {"radius", "max_v"}), "radius");
  EXPECT_EQ(nearest_name("zzzz", {"radius", "max_v"}), "");
}

}  // namespace
}  // namespace slalom
