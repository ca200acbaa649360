// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/studio/form.h>

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

TEST(FormModel, ReportsInvalidFieldsAndWhatWasExpected) {
  FormModel form(order_form());
  form.set_value(0, "-3");
  EXPECT_TRUE(mentions(form.error_of(0), {"'-3'", "expected", ">= 0"}));
  form.set_value(0, "1.5");
  EXPECT_TRUE(mentions(form.error_of(0), {"'1.5'", "expected", "integer"}));
  form.set_value(0, " ");
  EXPECT_TRUE(mentions(form.error_of(0), {"missing"}));
  form.set_value(0, " 7 ");
  EXPECT_EQ(form.error_of(0), "");
  form.set_value(1, "0");
  EXPECT_TRUE(mentions(form.first_error()->second, {"Width: '0'", "expected", "> 0"}));
  form.set_value(4, "bad");
  EXPECT_EQ(form.error_of(4), "is bad");
  form.set_value(4, "");
  EXPECT_EQ(form.error_of(4), "") << "it is optional";
}

TEST(FormModel, HidesAndDoesNotCheckFieldsOfAnotherChoice) {
  FormModel form(order_form());
  EXPECT_TRUE(form.is_shown(3));
  EXPECT_EQ(form.first_error()->first, 3U) << "'x' is not a number";
  form.choose(2, "maze");
  EXPECT_FALSE(form.is_shown(3));
  EXPECT_TRUE(mentions(form.error_of(2), {"missing"}));
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
  EXPECT_TRUE(mentions(form.error_of(2), {"'moon'", "expected", "random, maze, rooms"}));
}

TEST(FormModel, TogglesFlagsAndRefusesUnknownFields) {
  FormDescription description;
  description.title = "F";
  description.fields = {{"exact", "Exact", FieldKind::Flag}};
  FormModel form(description);
  EXPECT_EQ(form.values()["exact"], "false");
  form.choose(0, "");
  EXPECT_EQ(form.values()["exact"], "true");
  EXPECT_THROW(form.index_of("seed"), Error);
}

}  // namespace
}  // namespace slalom
