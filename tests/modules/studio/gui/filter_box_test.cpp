// SPDX-License-Identifier: BSD-3-Clause
#include "views/filter_box.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

namespace slalom {
namespace {

TEST(FilterBoxes, KeepTheFocusWhileEnterIsHeldDown) {
  int left = 0;
  nanogui::ref<FilterBox> box = new FilterBox(nullptr, [&] { ++left; });
  std::string applied;
  box->setCallback([&](const std::string& text) {
    applied = text;
    return true;
  });
  box->focusEvent(true);
  box->keyboardCharacterEvent('a');
  for (const int action : {GLFW_PRESS, GLFW_REPEAT, GLFW_REPEAT, GLFW_RELEASE}) {
    EXPECT_TRUE(box->keyboardEvent(GLFW_KEY_ENTER, 0, action, 0));
    EXPECT_TRUE(box->focused());
  }
  EXPECT_EQ(applied, "a");
  box->keyboardCharacterEvent('b');  // replaces the selected text
  box->keyboardEvent(GLFW_KEY_ENTER, 0, GLFW_PRESS, 0);
  EXPECT_EQ(applied, "b");
  EXPECT_EQ(left, 0);
}

}  // namespace
}  // namespace slalom
