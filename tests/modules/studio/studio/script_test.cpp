// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/studio/script.h>

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

namespace slalom {
namespace {

using Kind = ScriptCommand::Kind;

::testing::AssertionResult refuses(const std::string& text, const std::string& where,
                                   std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, where, words, [&] { parse_studio_script(text, "a.txt"); });
}

TEST(StudioScript, ReadsTargetsPartsAndModifiers) {
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
  EXPECT_EQ(script[1].target.element, "list");
  EXPECT_EQ(script[1].target.part, "row 3");
  EXPECT_EQ(script[1].target.x, 0.25);
  EXPECT_EQ(script[1].target.y, 0.75);
  EXPECT_EQ(script[1].modifiers, GLFW_MOD_CONTROL);
  EXPECT_TRUE(script[1].double_click);
  EXPECT_EQ(script[2].drag_target.y, 0.4);
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

TEST(StudioScript, ReportsTheLineOfAnError) {
  EXPECT_TRUE(refuses("wait idle\nclcik list", "a.txt:2: ",
                      {"command", "'clcik'",
                       "expected click, do, drag, drop, expect, fps, key, move, print, screenshot, "
                       "size, type, wait, wheel"}));
  EXPECT_TRUE(refuses("type \"open", "a.txt:1: ", {"quoted", "expected \""}));
  EXPECT_TRUE(refuses("wait a", "a.txt:1: ", {"'a'", "expected idle", "number of seconds"}));
  EXPECT_TRUE(
      refuses("wait until list has a", "a.txt:1: ", {"'has'", "expected contains, lacks or is"}));
  EXPECT_TRUE(refuses("size 10 10", "a.txt:1: ", {"size", "640 x 480 to 8192 x 8192 pixels"}));
  EXPECT_TRUE(refuses("click list row now",
                      "a.txt:1: ", {"'now'", "expected right, double, ctrl, shift or alt"}));
  EXPECT_TRUE(
      refuses("expect list has a", "a.txt:1: ", {"'has'", "expected contains, lacks or is"}));
  EXPECT_TRUE(refuses("drag view", "a.txt:1: ", {"target", "expected to ELEMENT [PART] [at X Y]"}));
  EXPECT_TRUE(refuses("do", "a.txt:1: ", {"end", "expected the id of an action"}));
  EXPECT_TRUE(refuses("wheel 1 view shift", "a.txt:1: ", {"'shift'", "end of the line"}));
  EXPECT_TRUE(refuses("wait idle long", "a.txt:1: ", {"'long'", "end of the line"}));
  EXPECT_TRUE(refuses("key Hyper+A", "a.txt:1: ",
                      {"Hyper+A", "modifier", "'hyper'", "expected Ctrl, Shift or Alt"}));
}

}  // namespace
}  // namespace slalom
