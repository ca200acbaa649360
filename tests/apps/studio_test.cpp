// SPDX-License-Identifier: BSD-3-Clause
#include "studio_fixture.h"

#include <mrpt/img/CImage.h>

#include <cstring>
#include <map>
#include <numeric>

namespace slalom {
namespace {

class Studio : public StudioTest {};

TEST_F(Studio, OpensSeveralLists) {
  make_list(5);
  make_list(3, "b.scenarios", 8);
  const std::string shown =
      expect_played("wait idle\nprint status\nprint list\n", "a.scenarios b.scenarios");
  EXPECT_NE(shown.find("b.scenarios: 3 scenarios"), std::string::npos) << shown;
  EXPECT_NE(shown.find("a.scenarios"), std::string::npos) << shown;
}

TEST_F(Studio, UndoesAndRedoesActions) {
  make_list(4);
  expect_played(
      "wait idle\n"
      "click list \"row 1\"\n"
      "key Delete\n"
      "wait idle\n"
      "expect list contains \"3 scenarios\"\n"
      "click menu Edit\n"
      "expect popup contains \"Undo: \"\n"
      "click popup edit.undo\n"
      "wait idle\n"
      "expect list contains \"4 scenarios\"\n"
      "key Ctrl+Y\n"
      "wait idle\n"
      "expect list contains \"3 scenarios\"\n",
      "a.scenarios");
  EXPECT_NE(run("slalom-scenarios list a.scenarios").out.find("random_0002"), std::string::npos);
  EXPECT_EQ(run("slalom-scenarios list a.scenarios").out.find("random_0001"), std::string::npos);
}

TEST_F(Studio, ReportsWhyAnActionIsDisabled) {
  expect_played(
      "click menu Edit\n"
      "expect popup contains \"Delete (no list is open)\"\n"
      "key Escape\n"
      "do edit.undo\n"
      "expect status is \"Undo: no list is open\"\n"
      "key F1\n"
      "expect dialog contains \"Ctrl+Z\"\n"
      "expect dialog contains \"F, S, D, G\"\n");
}

TEST_F(Studio, RestoresItsLayout) {
  expect_played(
      "size 1000 700\n"
      "drag splitter_list to menu at 0.5 0.5\n"
      "do layer.voronoi\n",
      "--settings deep/studio.ini");
  const std::string settings = read("deep/studio.ini");
  EXPECT_NE(settings.find("\nwidth = 1000"), std::string::npos) << settings;
  EXPECT_NE(settings.find("voronoi"), std::string::npos) << settings;
  const std::size_t at = settings.find("list_width = ");
  ASSERT_NE(at, std::string::npos) << settings;
  EXPECT_EQ(std::stoi(settings.substr(at + 13)), 400) << "the scenario stays the largest";
  expect_played("click menu Layers\nwait 0.1\nscreenshot a.png\n", "--settings deep/studio.ini");
  EXPECT_NE(read("deep/studio.ini").find("\nwidth = 1000"), std::string::npos);
}

TEST_F(Studio, IsNotLargerThanTheScreen) {
  write("studio.ini", "[window]\nwidth = 3000\nheight = 2000\n");
  expect_played("wait idle\n", "--settings studio.ini");
  const std::string settings = read("studio.ini");
  EXPECT_NE(settings.find("\nwidth = 1920"), std::string::npos) << settings;
  EXPECT_NE(settings.find("\nheight = 1080"), std::string::npos) << settings;
}

TEST_F(Studio, OpensRecentFilesOfEarlierSessions) {
  make_list(1, "a.scenarios");
  make_list(2, "b.scenarios");
  expect_played(
      "click menu File\n"
      "expect popup contains \"/b.scenarios\"\n"
      "key Escape\n"
      "wait idle\n",
      "a.scenarios b.scenarios --settings studio.ini");
  std::filesystem::remove(folder_ / "a.scenarios");
  expect_played(
      "click menu File\n"
      "expect popup contains \"/a.scenarios does not exist)\"\n"
      "click popup file.recent_2\n"
      "expect list lacks a.scenarios\n"
      "key Escape\n"
      "do file.recent_2\n"
      "expect status contains \"/a.scenarios does not exist\"\n"
      "click menu File\n"
      "click popup file.recent_1\n"
      "expect list contains \"tab 0: b.scenarios\"\n"
      "wait idle\n",
      "--settings studio.ini");
  expect_played("click menu File\nexpect popup lacks .scenarios\n");
}

TEST_F(Studio, OpensDespiteInvalidSettings) {
  write("studio.ini", "[window]\nwidth = many\n");
  expect_played("expect status contains \"studio.ini:2: [window] width\"\n",
                "--settings studio.ini");
}

TEST_F(Studio, ReportsInvalidFilesAndContinues) {
  write("broken.scenarios", "no list");
  make_list(2);
  expect_failure(environment() + "slalom-studio missing.scenarios", 3, {"missing.scenarios"});
  expect_played(
      "key Ctrl+O\n"
      "type broken.scenarios\n"
      "key Enter\n"
      "expect dialog contains \"broken.scenarios\"\n"
      "key Escape\n"
      "key Ctrl+O\n"
      "type a.scenarios\n"
      "key Enter\n"
      "wait idle\n"
      "expect status is \"a.scenarios: 2 scenarios\"\n");
}

TEST_F(Studio, SuggestsXvfbWithoutADisplay) {
  expect_failure("env -u DISPLAY -u WAYLAND_DISPLAY slalom-studio", 1,
                 {"cannot open a window", "OpenGL 3.3", "xvfb-run"});
}

TEST_F(Studio, ReportsTheLineOfAFailedExpectation) {
  const std::string command = environment() + "slalom-studio --script script.txt";
  write("script.txt", "wait idle\nexpect status contains nonsense\n");
  expect_failure(command, 1, {"script.txt:2: ", "'status'", "expected", "contains 'nonsense'"});
  write("script.txt", "click lits\n");
  expect_failure(command, 1, {"script.txt:1: ", "'lits'", "expected one of "});
  EXPECT_EQ(play("jump\n").status, 2);
}

/// The columns of each row in which two pictures differ.
std::map<int, std::vector<int>> differences(const std::string& one, const std::string& other) {
  mrpt::img::CImage a, b;
  EXPECT_TRUE(a.loadFromFile(one) && b.loadFromFile(other));
  EXPECT_EQ(a.getWidth(), b.getWidth());
  EXPECT_EQ(a.getHeight(), b.getHeight());
  std::map<int, std::vector<int>> columns;
  for (int y = 0; y < static_cast<int>(a.getHeight()); ++y)
    for (int x = 0; x < static_cast<int>(a.getWidth()); ++x)
      if (std::memcmp(a(x, y), b(x, y), 3) != 0) columns[y].push_back(x);
  return columns;
}

double mean(const std::vector<int>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

TEST_F(Studio, FindsAndRunsActionsByTheirWords) {
  make_list(2);
  expect_played(
      "wait idle\n"
      "key Ctrl+K\n"
      "expect finder contains \"File: New list...\"\n"
      "expect finder contains \"Generate: Shrink run... (\"\n"
      "type \"copy list\"\n"
      "expect finder contains \"> Edit: Copy to another list... (nothing is selected)\"\n"
      "expect finder lacks \"New list\"\n"
      "screenshot gray.png\n"
      "key Enter\n"
      "expect finder contains \"Copy to\"\n"
      "key Ctrl+A\n"
      "type \"all SHOW\"\n"
      "expect finder contains \"> View: Show all\"\n"
      "key Ctrl+A\n"
      "type \"nothing so\"\n"
      "expect finder lacks :\n"
      "screenshot none.png\n"
      "key Enter\n"
      "key Escape\n"
      "key Ctrl+K\n"
      "expect finder contains \"New list\"\n"
      "type about\n"
      "key Enter\n"
      "expect dialog contains Version\n"
      "key Escape\n"
      "key Ctrl+K\n"
      "type legend\n"
      "click finder view.legend\n"
      "key Ctrl+K\n"
      "type voronoi\n"
      "click view at 0.5 0.9\n"
      "key F6\n"
      "key Ctrl+Z\n"
      "expect status contains Undo\n",
      "a.scenarios");
}

TEST_F(Studio, MarksInAMenuWhatIsOn) {
  expect_played(
      "do view.legend\n"
      "click menu Layers\n"
      "wait 0.2\n"
      "screenshot off.png\n"
      "key Escape\n"
      "do layer.voronoi\n"
      "click menu Layers\n"
      "wait 0.2\n"
      "screenshot on.png\n");
  const auto mark = differences(folder_ / "off.png", folder_ / "on.png");
  ASSERT_GE(mark.size(), 5U);
  EXPECT_LE(mark.rbegin()->first - mark.begin()->first, 20) << "one line of the menu, nothing else";
  // A check mark ends at the upper right; the box in place of a missing letter is symmetric.
  EXPECT_GT(mean(mark.begin()->second), mean(mark.rbegin()->second) + 2);
}

}  // namespace
}  // namespace slalom
