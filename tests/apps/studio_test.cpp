#include "studio_fixture.h"

namespace slalom {
namespace {

class Studio : public StudioTest {};

TEST_F(Studio, OpensListsSideBySide) {
  make_list(5);
  make_list(3, "b.scenarios", 8);
  const std::string shown =
      expect_played("wait idle\nprint status\nprint list\n", "a.scenarios b.scenarios");
  EXPECT_NE(shown.find("b.scenarios: 3 scenarios"), std::string::npos) << shown;
  EXPECT_NE(shown.find("a.scenarios"), std::string::npos) << shown;
}

TEST_F(Studio, TakesBackWhatWasDoneAndDoesItAgain) {
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

TEST_F(Studio, SaysWhyAnActionCannotBeDone) {
  expect_played(
      "click menu Edit\n"
      "expect popup contains \"Delete (no list is open)\"\n"
      "key Escape\n"
      "do edit.undo\n"
      "expect status contains \"Undo: no list is open\"\n"
      "expect dialog contains \"no list is open\"\n"
      "key Enter\n"
      "key F1\n"
      "expect dialog contains \"Ctrl+Z\"\n");
}

TEST_F(Studio, RemembersHowItWasArranged) {
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
  EXPECT_NEAR(std::stoi(settings.substr(at + 13)), 500, 20);
  expect_played("click menu Layers\nwait 0.1\nscreenshot a.png\n", "--settings deep/studio.ini");
  EXPECT_NE(read("deep/studio.ini").find("\nwidth = 1000"), std::string::npos);
}

TEST_F(Studio, OpensAllTheSameWhenItsSettingsCannotBeUsed) {
  write("studio.ini", "[window]\nwidth = many\n");
  expect_played("expect status contains \"studio.ini:2: [window] width\"\n",
                "--settings studio.ini");
}

TEST_F(Studio, SaysWhatIsWrongWithFilesAndGoesOn) {
  write("broken.scenarios", "no list");
  make_list(2);
  expect_refusal(environment() + "slalom-studio missing.scenarios", 3, {"missing.scenarios"});
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

TEST_F(Studio, SaysHowToRunWithoutADisplay) {
  expect_refusal("env -u DISPLAY -u WAYLAND_DISPLAY slalom-studio", 1,
                 {"cannot open a window", "OpenGL 3.3", "xvfb-run"});
}

TEST_F(Studio, SaysWhichLineOfAScriptDoesNotHold) {
  Ended ended = play("wait idle\nexpect status contains nonsense\n");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("script.txt:2: 'status' shows ''; expected that it contains 'nonsense'"),
            std::string::npos)
      << ended.err;
  ended = play("click lits\n");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("script.txt:1: no element 'lits' is shown; expected one of "),
            std::string::npos)
      << ended.err;
  EXPECT_EQ(play("jump\n").status, 2);
}

}  // namespace
}  // namespace slalom
