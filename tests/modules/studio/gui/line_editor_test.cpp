// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/line_editor.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(LineEditor, InsertsErasesAndSelectsCharactersOfAnyLength) {
  LineEditor line("wäg");
  line.move(-1, false);
  line.erase_backward();
  EXPECT_EQ(line.text(), "wg") << "both bytes of the character";
  line.insert(
      "\xC3\xBC"
      "e\n");
  EXPECT_EQ(line.text(), "wüeg") << "without the line break";
  line.move(-2, true);
  EXPECT_EQ(line.selected(), "üe");
  line.insert("a");
  EXPECT_EQ(line.text(), "wag");
  line.move_to_begin(true);
  line.erase_forward();
  EXPECT_EQ(line.text(), "g");
  line.move_to_begin(false);
  line.erase_forward();
  line.erase_forward();
  line.erase_backward();
  EXPECT_EQ(line.text(), "");
}

TEST(LineEditor, LeavesASelectionInTheDirectionOfTheMove) {
  LineEditor line("abcdef");
  line.select_all();
  line.move(-1, false);
  EXPECT_EQ(line.cursor(), 0U);
  line.select_all();
  line.move(1, false);
  EXPECT_EQ(line.cursor(), 6U);
}

TEST(LineEditor, NeverStopsWithinACharacterAndLimitsItsLength) {
  LineEditor line("äö");
  line.move_to(1, false);
  EXPECT_EQ(line.cursor(), 0U);
  line.move_to(99, false);
  EXPECT_EQ(line.cursor(), 4U);
  line.insert(std::string(LineEditor::kMaxLength, 'x'));
  EXPECT_EQ(line.text(), "äö");
}

TEST(LineEditor, EncodesCodePointsAsUtf8) {
  EXPECT_EQ(utf8_of('a'), "a");
  EXPECT_EQ(utf8_of(0xE4), "ä");
  EXPECT_EQ(utf8_of(0x2026), "…");
  EXPECT_EQ(utf8_of(0x1F600), "😀");
  EXPECT_EQ(utf8_of(0x0A), "");
  EXPECT_EQ(utf8_of(0xD800), "");
}

}  // namespace
}  // namespace slalom
