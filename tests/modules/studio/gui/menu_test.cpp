// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/menu.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

namespace slalom {
namespace {

/// A menu of three lines, the second of them disabled.
class Menus : public testing::Test {
 protected:
  void SetUp() override {
    menu_->open({10, 20}, 200, 500,
                {{"a", "Undo", "Ctrl+Z", "Undoes."},
                 {"b", "Redo", "", "Repeats.", [this] { return reason_; }},
                 {"c", "Close", "", "Closes."}},
                0, [this](std::size_t line) { chosen_ = line; });
  }
  bool key(int key) { return menu_->keyboardEvent(key, 0, GLFW_PRESS, 0); }

  nanogui::ref<Menu> menu_ = new Menu(nullptr, "popup");
  std::optional<std::size_t> chosen_;
  std::string reason_ = "there is nothing to redo";
};

TEST_F(Menus, ChooseByKeysAroundTheEnds) {
  EXPECT_TRUE(key(GLFW_KEY_UP));
  EXPECT_TRUE(key(GLFW_KEY_ENTER));
  EXPECT_EQ(chosen_, 2U);
  EXPECT_FALSE(menu_->visible());
}

TEST_F(Menus, DoNotChooseDisabledLines) {
  key(GLFW_KEY_DOWN);
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(chosen_);
  EXPECT_TRUE(menu_->visible());
  EXPECT_EQ(menu_->text(), "Undo\n> Redo (there is nothing to redo)\nClose\n");
}

TEST_F(Menus, EnableALineWhileTheyAreOpen) {
  key(GLFW_KEY_DOWN);
  reason_.clear();
  EXPECT_EQ(menu_->text(), "Undo\n> Redo\nClose\n");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(chosen_, 1U);
}

TEST_F(Menus, CloseWithEscape) {
  EXPECT_TRUE(key(GLFW_KEY_ESCAPE));
  EXPECT_FALSE(menu_->visible());
  EXPECT_FALSE(chosen_);
}

TEST_F(Menus, ChooseByAClick) {
  const ScreenRect line = *menu_->rect_of("c");
  const nanogui::Vector2i at(menu_->position().x() + static_cast<int>(line.left + 5),
                             menu_->position().y() + static_cast<int>(line.top + 5));
  menu_->mouseButtonEvent(at, GLFW_MOUSE_BUTTON_LEFT, true, 0);
  EXPECT_EQ(chosen_, 2U);
}

/// A class of its own, since MRPT's library frees its widgets itself, in another way than they are
/// allocated here.
struct PlainWidget : nanogui::Widget {
  PlainWidget() : nanogui::Widget(nullptr) {}
};

TEST(MenuBars, OpenTheMenuOfAScenarioWithinTheWindow) {
  Actions actions;
  std::string run;
  actions.add({"a.b", "A", "First", "", "Does.", [] {}});
  actions.add({"a.c", "A", "Second", "", "Does.", [] {}});
  nanogui::ref<PlainWidget> window = new PlainWidget;
  window->setSize({800, 600});
  auto* bar = new MenuBar(window.get(), actions, [&run](const std::string& id) { run = id; });
  bar->open_context({790, 595}, {"a.c", "a.b"});
  EXPECT_EQ(bar->popup().text(), "> Second\nFirst\n");
  EXPECT_LE(bar->popup().position().x() + bar->popup().width(), 800);
  EXPECT_LE(bar->popup().position().y() + bar->popup().height(), 600);
  EXPECT_FALSE(bar->popup_key(GLFW_KEY_RIGHT, 0)) << "it has no neighbors, and closes";
  EXPECT_FALSE(bar->popup().visible());
  bar->open_context({100, 100}, {"a.c", "a.b"});
  EXPECT_EQ(bar->popup().position(), nanogui::Vector2i(100, 100));
  bar->popup_key(GLFW_KEY_ENTER, 0);
  EXPECT_EQ(run, "a.c");
}

TEST_F(Menus, ScrollToALineWhereTheyDoNotFit) {
  menu_->open({0, 0}, 100, 60, {{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", "4"}}, 0, {});
  const ScreenRect last = *menu_->rect_of("d");
  EXPECT_LE(last.bottom(), menu_->height());
  EXPECT_LT(menu_->rect_of("a")->top, last.top);
  EXPECT_FALSE(menu_->rect_of("e"));
}

}  // namespace
}  // namespace slalom
