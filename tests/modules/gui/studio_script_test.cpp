#include "error_text.h"

#include <slalom/gui/studio_script.h>

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

namespace slalom {
namespace {

using Kind = ScriptCommand::Kind;

std::string refusal(const std::string& text) {
  return error_text(Culprit::Usage, [&] { parse_studio_script(text, "a.txt"); });
}

TEST(StudioScript, ReadsPlacesPartsAndManners) {
  const auto script = parse_studio_script(
      "# a comment\n"
      "size 1280 800\n"
      "\n"
      "click list \"row 3\" at 0.25 0.75 ctrl double   # and another\n"
      "drag view at 0.1 0.2 to view at 0.3 0.4 right\n"
      "wheel -2 view\n"
      "type \"density > 0.2 \\\"x\\\"\"\n",
      "a.txt");
  ASSERT_EQ(script.size(), 5U);
  EXPECT_EQ(script[0].width, 1280);
  EXPECT_EQ(script[1].kind, Kind::Click);
  EXPECT_EQ(script[1].line, 4);
  EXPECT_EQ(script[1].place.element, "list");
  EXPECT_EQ(script[1].place.part, "row 3");
  EXPECT_EQ(script[1].place.x, 0.25);
  EXPECT_EQ(script[1].place.y, 0.75);
  EXPECT_EQ(script[1].modifiers, GLFW_MOD_CONTROL);
  EXPECT_TRUE(script[1].twice);
  EXPECT_EQ(script[2].target.y, 0.4);
  EXPECT_TRUE(script[2].right);
  EXPECT_EQ(script[3].number, -2);
  EXPECT_EQ(script[4].text, "density > 0.2 \"x\"");
}

TEST(StudioScript, ReadsKeys) {
  const auto script = parse_studio_script("key Ctrl+Shift+z\nkey F5\nkey PageDown", "a.txt");
  EXPECT_EQ(script[0].key.key, GLFW_KEY_Z);
  EXPECT_EQ(script[0].key.modifiers, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
  EXPECT_EQ(script[1].key.key, GLFW_KEY_F5);
  EXPECT_EQ(script[2].key.key, GLFW_KEY_PAGE_DOWN);
}

TEST(StudioScript, SaysInWhichLineItIsWrong) {
  EXPECT_EQ(
      refusal("wait idle\nclcik list"),
      "a.txt:2: 'clcik' is no command; expected click, do, drag, drop, expect, fps, key, move, "
      "print, screenshot, size, type, wait, wheel");
  EXPECT_EQ(refusal("type \"open"), "a.txt:1: a quoted text does not end; expected \"");
  EXPECT_EQ(refusal("wait a"), "a.txt:1: 'a' is no number; expected idle, or a number of seconds");
  EXPECT_EQ(refusal("size 10 10"),
            "a.txt:1: the window cannot have that size; expected 640 x 480 to 8192 x 8192 pixels");
  EXPECT_EQ(refusal("click list row now"),
            "a.txt:1: 'now' is not known here; expected right, double, ctrl, shift or alt");
  EXPECT_EQ(refusal("expect list has a"),
            "a.txt:1: 'has' is no relation; expected contains, lacks or is");
  EXPECT_EQ(refusal("drag view"),
            "a.txt:1: a drag needs a target; expected to ELEMENT [PART] [at X Y]");
  EXPECT_EQ(refusal("do"), "a.txt:1: the line ends early; expected the id of an action");
  EXPECT_EQ(refusal("wheel 1 view shift"),
            "a.txt:1: 'shift' is too much; expected the end of the line");
  EXPECT_EQ(refusal("wait idle long"), "a.txt:1: 'long' is too much; expected the end of the line");
  EXPECT_EQ(refusal("key Hyper+A"),
            "a.txt:1: key Hyper+A: 'hyper' is no modifier; expected Ctrl, Shift or Alt");
}

}  // namespace
}  // namespace slalom
