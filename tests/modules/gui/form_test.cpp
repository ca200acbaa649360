#include <slalom/core/error.h>
#include <slalom/gui/form.h>
#include <slalom/gui/line_editor.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

FormDescription order_form() {
  FormDescription form;
  form.title = "Order";
  FormField seed{"seed", "Seed", FieldKind::Integer, "1"};
  seed.range = Range::at_least(0);
  FormField width{"width", "Width", FieldKind::Number, "12", "m"};
  width.range = Range::positive();
  FormField families{"families", "Families", FieldKind::Choices, "maze"};
  families.choices = {"random", "maze", "rooms"};
  FormField loops{"loops", "Loops", FieldKind::Number, "x"};
  loops.shown_if_key = "families";
  loops.shown_if_value = "maze";
  FormField name{"name", "Name", FieldKind::Text, ""};
  name.required = false;
  name.check = [](const std::string& text) {
    return text == "bad" ? std::string("is bad") : std::string();
  };
  form.fields = {seed, width, families, loops, name};
  return form;
}

TEST(FormModel, TellsWhatIsWrongWithAFieldAndWhatWasExpected) {
  FormModel form(order_form());
  form.set_value(0, "-3");
  EXPECT_EQ(form.error_of(0), "'-3' is not valid; expected a whole number >= 0");
  form.set_value(0, "1.5");
  EXPECT_EQ(form.error_of(0), "'1.5' is not valid; expected a whole number >= 0");
  form.set_value(0, " ");
  EXPECT_EQ(form.error_of(0), "is missing");
  form.set_value(0, " 7 ");
  EXPECT_EQ(form.error_of(0), "");
  form.set_value(1, "0");
  EXPECT_EQ(form.first_error()->second, "Width: '0' is not valid; expected a number > 0");
  form.set_value(4, "bad");
  EXPECT_EQ(form.error_of(4), "is bad");
  form.set_value(4, "");
  EXPECT_EQ(form.error_of(4), "") << "it need not be given";
}

TEST(FormModel, HidesAndDoesNotCheckFieldsOfAnotherChoice) {
  FormModel form(order_form());
  EXPECT_TRUE(form.is_shown(3));
  EXPECT_EQ(form.first_error()->first, 3U) << "'x' is no number";
  form.choose(2, "maze");
  EXPECT_FALSE(form.is_shown(3));
  EXPECT_EQ(form.error_of(2), "is missing");
  form.choose(2, "rooms");
  EXPECT_EQ(form.first_error(), std::nullopt);
}

TEST(FormModel, KeepsChoicesInTheirOrder) {
  FormModel form(order_form());
  form.choose(2, "rooms");
  form.choose(2, "random");
  EXPECT_EQ(form.values()["families"], "random, maze, rooms");
  form.choose(2, "maze");
  EXPECT_EQ(form.values()["families"], "random, rooms");
  form.set_value(2, "random, moon");
  EXPECT_EQ(form.error_of(2), "'moon' is not valid; expected one of random, maze, rooms");
}

TEST(FormModel, TurnsFlagsAndNamesItsFields) {
  FormDescription description;
  description.title = "F";
  description.fields = {{"exact", "Exact", FieldKind::Flag}};
  FormModel form(description);
  EXPECT_EQ(form.values()["exact"], "false");
  form.choose(0, "");
  EXPECT_EQ(form.values()["exact"], "true");
  EXPECT_THROW(form.index_of("seed"), Error);
}

TEST(LineEditor, TypesErasesAndSelectsLettersOfAnyLength) {
  LineEditor line("wäg");
  line.move(-1, false);
  line.erase_before();
  EXPECT_EQ(line.text(), "wg") << "both bytes of the letter";
  line.insert(
      "\xC3\xBC"
      "e\n");
  EXPECT_EQ(line.text(), "wüeg") << "without the line break";
  line.move(-2, true);
  EXPECT_EQ(line.selected(), "üe");
  line.insert("a");
  EXPECT_EQ(line.text(), "wag");
  line.move_to_begin(true);
  line.erase_behind();
  EXPECT_EQ(line.text(), "g");
  line.move_to_begin(false);
  line.erase_behind();
  line.erase_behind();
  line.erase_before();
  EXPECT_EQ(line.text(), "");
}

TEST(LineEditor, LeavesASelectionOnTheSideItMovesTo) {
  LineEditor line("abcdef");
  line.select_all();
  line.move(-1, false);
  EXPECT_EQ(line.cursor(), 0U);
  line.select_all();
  line.move(1, false);
  EXPECT_EQ(line.cursor(), 6U);
}

TEST(LineEditor, NeverStopsWithinALetterAndTakesNoMoreThanItHolds) {
  LineEditor line("äö");
  line.move_to(1, false);
  EXPECT_EQ(line.cursor(), 0U);
  line.move_to(99, false);
  EXPECT_EQ(line.cursor(), 4U);
  line.insert(std::string(LineEditor::kLongest, 'x'));
  EXPECT_EQ(line.text(), "äö");
}

TEST(LineEditor, WritesLettersAsUtf8) {
  EXPECT_EQ(utf8_of('a'), "a");
  EXPECT_EQ(utf8_of(0xE4), "ä");
  EXPECT_EQ(utf8_of(0x2026), "…");
  EXPECT_EQ(utf8_of(0x1F600), "😀");
  EXPECT_EQ(utf8_of(0x0A), "");
  EXPECT_EQ(utf8_of(0xD800), "");
}

}  // namespace
}  // namespace slalom
