// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/studio/actions.h>

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>
#include <stdexcept>

namespace slalom {
namespace {

TEST(Actions, AreFoundByIdKeyAndMenu) {
  Actions actions;
  int done = 0;
  actions.add({"file.open", "File", "Open", "Ctrl+O", "Opens.", [&] { ++done; }});
  actions.add({"edit.undo", "Edit", "Undo", "Ctrl+Z", "Undoes.", [&] { done += 10; }});
  actions.add({"file.quit", "File", "Quit", "", "Ends.", [] {}});
  EXPECT_EQ(actions.menus(), (std::vector<std::string>{"File", "Edit"}));
  EXPECT_EQ(actions.of_menu("File").size(), 2U);
  actions.run("file.open");
  actions.find(key_stroke_of("ctrl+z"))->run();
  EXPECT_EQ(done, 11);
  EXPECT_EQ(actions.find(key_stroke_of("Ctrl+Y")), nullptr);
}

TEST(Actions, MatchWordsInAnyOrderAndCase) {
  Actions actions;
  actions.add({"file.open", "File", "Open list...", "", "", [] {}});
  actions.add({"file.results", "File", "Open results...", "", "", [] {}});
  actions.add({"list.sort", "List", "Sort...", "", "", [] {}, {}, [] { return "Order by name"; }});
  const auto matching = [&](const std::string& words) {
    std::string ids;
    for (const Action* action : actions.matching(words)) ids += action->id + " ";
    return ids;
  };
  EXPECT_EQ(matching(""), "file.open file.results list.sort ");
  EXPECT_EQ(matching("  LIST open"), "file.open ");
  EXPECT_EQ(matching("list"), "file.open list.sort ") << "of the label, and of the menu";
  EXPECT_EQ(matching("name"), "list.sort ") << "the label that is shown";
  EXPECT_EQ(matching("open closed"), "");
}

TEST(Actions, ReportWhyTheyAreDisabled) {
  Actions actions;
  actions.add({"edit.undo", "Edit", "Undo", "", "Undoes.", [] { FAIL(); },
               [] { return "nothing was done"; }});
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "Undo: ", {"nothing was done"},
                           [&] { actions.run("edit.undo"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "action edit.unod: ", {"unknown", "edit.undo"},
                           [&] { actions.run("edit.unod"); }));
}

TEST(Actions, RequireUniqueIdsAndShortcuts) {
  Actions actions;
  actions.add({"a", "M", "A", "Ctrl+A", "", [] {}});
  EXPECT_THROW(actions.add({"a", "M", "A", "", "", [] {}}), std::logic_error);
  EXPECT_THROW(actions.add({"b", "M", "B", "ctrl+a", "", [] {}}), std::logic_error);
}

TEST(KeyStrokes, TypeTheLettersOfAnAmericanKeyboard) {
  EXPECT_EQ(key_stroke_typing('s'), (KeyStroke{GLFW_KEY_S, 0}));
  EXPECT_EQ(key_stroke_typing('S'), (KeyStroke{GLFW_KEY_S, GLFW_MOD_SHIFT}));
  EXPECT_EQ(key_stroke_typing(' '), (KeyStroke{GLFW_KEY_SPACE, 0}));
  EXPECT_EQ(key_stroke_typing('>'), (KeyStroke{GLFW_KEY_PERIOD, GLFW_MOD_SHIFT}));
  EXPECT_EQ(key_stroke_typing('='), (KeyStroke{GLFW_KEY_EQUAL, 0}));
  EXPECT_EQ(key_stroke_typing(0xE9).key, GLFW_KEY_UNKNOWN);  // e with an accent
  for (unsigned int letter = ' '; letter <= '~'; ++letter)
    EXPECT_EQ(letter_typed_by(key_stroke_typing(letter)), letter);
}

TEST(KeyStrokes, OfTextsAreThoseThatTypeMoveAndEdit) {
  for (const char* name : {"s", "Shift+S", "Delete", "Left", "Enter", "Ctrl+A", "Ctrl+Z"})
    EXPECT_TRUE(is_key_of_text(key_stroke_of(name))) << name;
  EXPECT_TRUE(is_key_of_text(key_stroke_typing(0xE9)));
  for (const char* name : {"F5", "Ctrl+O", "Ctrl+Shift+C", "Ctrl+PageUp", "Alt+A"})
    EXPECT_FALSE(is_key_of_text(key_stroke_of(name))) << name;
}

TEST(KeyStrokes, TypeNothingWithoutALetterOrWithControl) {
  EXPECT_EQ(letter_typed_by(key_stroke_of("Ctrl+S")), 0U);
  EXPECT_EQ(letter_typed_by(key_stroke_of("Alt+Shift+S")), 0U);
  EXPECT_EQ(letter_typed_by(key_stroke_of("Delete")), 0U);
  EXPECT_EQ(letter_typed_by(key_stroke_of("F5")), 0U);
}

}  // namespace
}  // namespace slalom
