// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/ini_file.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <unistd.h>

namespace slalom {
namespace {

TEST(IniFile, ReadsSectionsKeysAndComments) {
  const IniFile ini = IniFile::from_text(
      "# a comment\n[robot]\nradius = 0.3  # meters\nname = a;b\n; another\n[method.nd]\nclass = "
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

TEST(IniFile, RecordsTheLineOfAKey) {
  const IniFile ini = IniFile::from_text("[a]\n\nx = 1\n", "f.ini");
  EXPECT_EQ(ini.where("a", "x"), "f.ini:3: [a] x");
  EXPECT_EQ(ini.where("a"), "f.ini:1: [a]");
}

TEST(IniFile, DefinitionsDoNotShiftLineNumbers) {
  const IniFile ini = IniFile::from_text("@define R 1\n[a]\nx = ${R}\n", "f.ini");
  EXPECT_EQ(ini.where("a", "x"), "f.ini:3: [a] x");
}

testing::AssertionResult refused_text(const std::string& text, const std::string& where,
                                      std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, where, words, [&] { IniFile::from_text(text, "f.ini"); });
}

TEST(IniFile, MalformedLinesAreRefusedWithTheirLineNumber) {
  EXPECT_TRUE(refused_text("[a\n", "f.ini:1: ", {"'[a'", "expected [section]"}));
  EXPECT_TRUE(
      refused_text("[a]\nhello\n", "f.ini:2: ", {"'hello'", "expected [section] or key = value"}));
  EXPECT_TRUE(refused_text("x = 1\n[a]\n", "f.ini:1: ",
                           {"'x = 1' is of no section", "expected a line [section] before it"}));
  EXPECT_TRUE(refused_text("[a]\nx=1\nx=2\n", "f.ini:3: [a] x: ", {"duplicate"}));
}

TEST(IniFile, AMissingFileIsAFileError) {
  EXPECT_TRUE(throws_error(ErrorKind::File, "/nonexistent/x.ini: ", {"read"},
                           [] { IniFile::load("/nonexistent/x.ini"); }));
}

class IniFileOnDisk : public testing::Test {
 protected:
  void TearDown() override { std::remove(path_.c_str()); }
  std::string message_of_loading(const std::string& content) const {
    std::ofstream(path_, std::ios::binary) << content;
    return error_text(ErrorKind::File, [this] { IniFile::load(path_); });
  }
  const std::string path_ = testing::TempDir() + "slalom_ini_file_test_" + std::to_string(getpid());
};

TEST_F(IniFileOnDisk, MustBeAText) {
  const std::string refusal = path_ + ": is not a text file; expected a configuration file (.ini)";
  EXPECT_EQ(message_of_loading("\x89PNG\r\n\x1a\n" + std::string(3, '\0') + "\rIHDR"), refusal);
  EXPECT_EQ(message_of_loading("SQLite format 3" + std::string(1, '\0')), refusal);
  EXPECT_EQ(message_of_loading("[a]\nx = \x1b[31m\n"), refusal);
}

TEST_F(IniFileOnDisk, MayHaveTabsLinesOfOtherSystemsAndOldLetters) {
  EXPECT_EQ(message_of_loading("[a]\r\nx\t= 1\f\r\n# caf\xe9\r\n"), "(no error)");
}

TEST(IniFile, RefusesValuesThatAreNotUtf8) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.ini:2: ",
                           {"byte 10 of 'name = ca\\xe9' is not UTF-8", "expected text in UTF-8"},
                           [] { IniFile::from_text("[a]\nname = ca\xe9\n", "a.ini"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "a.ini:1: ", {"is not UTF-8"},
                           [] { IniFile::from_text("[caf\xe9]\n", "a.ini"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set: ", {"is not UTF-8"}, [] {
    IniFile ini = IniFile::from_text("");
    ini.override_key("a.b=\xff");
  }));
  EXPECT_EQ(IniFile::from_text("[a]\nname = caf\xc3\xa9\n").get("a", "name"), "caf\xc3\xa9");
}

TEST(IniFile, OverridesReplaceOrAddAKey) {
  IniFile ini = IniFile::from_text("[method.nd]\nclass = X\n");
  ini.override_key("method.nd.class=Y");
  ini.override_key("robot.radius = 0.4");
  EXPECT_EQ(ini.get("method.nd", "class"), "Y");
  EXPECT_EQ(ini.get("robot", "radius"), "0.4");
  EXPECT_TRUE(ini.is_overridden("method.nd", "class"));
  ini = IniFile::from_text("[method.nd]\nclass = X\n", "--set x");
  EXPECT_FALSE(ini.is_overridden("method.nd", "class")) << ini.where("method.nd", "class");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set radius: ", {"SECTION.KEY=VALUE"},
                           [&] { ini.override_key("radius"); }));
}

TEST(IniFile, AnOverrideOfTuneMayHaveAKeyWithDots) {
  IniFile ini = IniFile::from_text("[tune]\nCHolonomicND.X = 0, 1\n");
  ini.override_key("tune.CHolonomicND.X=0,2");
  ini.override_key("tune.margin=0,3");
  EXPECT_EQ(ini.get("tune", "CHolonomicND.X"), "0,2");
  EXPECT_EQ(ini.get("tune", "margin"), "0,3");
  EXPECT_EQ(ini.keys("tune").size(), 2U);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set tune.=1: ", {"SECTION.KEY=VALUE"},
                           [&] { ini.override_key("tune.=1"); }));
}

TEST(IniFile, AnOverrideWithoutAValueIsRefusedWithTheAssignment) {
  IniFile ini = IniFile::from_text("");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "--set robot.radius: no value",
                           {"expected robot.radius=VALUE"},
                           [&] { ini.override_key("robot.radius"); }));
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

TEST(IniFile, KnowsWhatAValueCanHold) {
  for (const char* value : {"", "a b", "/a,b/c=d", "a#b", "3 m"})
    EXPECT_TRUE(IniFile::can_hold(value)) << value;
  for (const char* value : {"a #b", "a ;b", "#", " a", "a\nb"})
    EXPECT_FALSE(IniFile::can_hold(value)) << value;
}

TEST(IniFile, UnknownSectionsAreRefusedWithTheNearestName) {
  const IniFile ini = IniFile::from_text("[robto]\nradius = 1\n", "f.ini");
  EXPECT_TRUE(
      throws_error(ErrorKind::Usage, "f.ini:1: [robto]: ", {"unknown", "expected [robot]"}, [&] {
        ini.reject_unknown_sections({"robot", "method.*"});
      }));
  IniFile::from_text("[method.x]\n").reject_unknown_sections({"method.*"});
}

TEST(IniFile, ManyKeysKeepTheirOrder) {
  constexpr int kKeys = 100000;  // minutes if each were compared with all others
  std::string text = "[a]\n";
  for (int i = 0; i < kKeys; ++i) text += "k" + std::to_string(kKeys - i) + " = 1\n";
  IniFile ini = IniFile::from_text(text);
  EXPECT_EQ(ini.keys("a").size(), kKeys);
  EXPECT_EQ(ini.keys("a").front(), "k100000");
  ini.set("a", "k5", "2");
  ini.set("a", "new", "3");
  ini.remove("a", "k1");
  EXPECT_EQ(ini.keys("a").back(), "new");
  EXPECT_EQ(ini.get("a", "k5"), "2");
  EXPECT_FALSE(ini.get("a", "k1"));
}

TEST(IniFile, NamesOfSectionsAreShort) {
  const std::string name(1001, 'x');
  EXPECT_THROW(IniFile::from_text("[method." + name + "]\na = 1\n"), Error);
  EXPECT_NO_THROW(IniFile::from_text("[method." + name.substr(1) + "]\na = 1\n"));
}

}  // namespace
}  // namespace slalom
