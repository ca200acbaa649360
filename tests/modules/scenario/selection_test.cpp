#include "error_text.h"

#include <slalom/scenario/selection.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using Node = SelectionNode;

const SelectionVocabulary kVocabulary = {{"density", "confinement", "clearness"},
                                         {"name", "id", "tag", "generator"},
                                         {{"by_density", 3}}};

SelectionPtr parse(const std::string& text) {
  return parse_selection(text, kVocabulary);
}

std::string refusal(const std::string& text) {
  return error_text(Culprit::Usage, [&] { parse(text); });
}

template <typename What>
What as(const SelectionPtr& selection) {
  return std::get<What>(selection->what);
}

TEST(Selection, AndBindsCloserThanOr) {
  const SelectionPtr selection = parse("density > 1 or density > 2 and density > 3");
  const auto either = as<Node::Joined>(selection);
  ASSERT_EQ(either.how, Node::Connective::Or);
  ASSERT_EQ(either.parts.size(), 2U);
  EXPECT_EQ(as<Node::Compare>(either.parts[0]).right, SelectionOperand(1.0));
  EXPECT_EQ(as<Node::Joined>(either.parts[1]).how, Node::Connective::And);
  const auto both = as<Node::Joined>(parse("(density > 1 or density > 2) and density > 3"));
  EXPECT_EQ(both.how, Node::Connective::And);
}

TEST(Selection, NotBindsClosest) {
  const auto both = as<Node::Joined>(parse("not density > 1 and not (tag = a or tag = b)"));
  ASSERT_EQ(both.how, Node::Connective::And);
  for (const SelectionPtr& part : both.parts)
    EXPECT_EQ(as<Node::Joined>(part).how, Node::Connective::Not);
}

TEST(Selection, NumbersStandOnEitherSide) {
  const auto compare = as<Node::Compare>(parse("-1.5e-3 <= density"));
  EXPECT_EQ(compare.left, SelectionOperand(-1.5e-3));
  EXPECT_EQ(compare.how, Comparison::LessEqual);
  EXPECT_EQ(compare.right, SelectionOperand(std::string("density")));
  EXPECT_EQ(as<Node::Compare>(parse("density<clearness")).right,
            SelectionOperand(std::string("clearness")));
  const auto chain = as<Node::Joined>(parse("0.1 <= density < 0.2"));
  EXPECT_EQ(as<Node::Compare>(chain.parts[1]).right, SelectionOperand(0.2));
}

TEST(Selection, IntervalsSayWhichEndsBelong) {
  const auto ends = [](const std::string& text) {
    const SelectionPtr selection = parse(text);
    const auto w = as<Node::Within>(selection);
    return std::make_tuple(w.low, w.low_open, w.high, w.high_open);
  };
  EXPECT_EQ(ends("density between 1 and 2"), std::make_tuple(1.0, false, 2.0, false));
  EXPECT_EQ(ends("density in [1, 2]"), std::make_tuple(1.0, false, 2.0, false));
  EXPECT_EQ(ends("density in [1, 2)"), std::make_tuple(1.0, false, 2.0, true));
  EXPECT_EQ(ends("density in (1, 2]"), std::make_tuple(1.0, true, 2.0, false));
  EXPECT_EQ(as<Node::AmongNumbers>(parse("density in (1, 2)")).values, (std::vector<double>{1, 2}));
}

TEST(Selection, TextsMayBeBareOrQuoted) {
  const auto values = [](const std::string& text) {
    return as<Node::AmongTexts>(parse(text)).values;
  };
  EXPECT_EQ(values("name = room_1"), std::vector<std::string>{"room_1"});
  EXPECT_EQ(values("name == 'it''s a \"room\"'"), std::vector<std::string>{"it's a \"room\""});
  EXPECT_EQ(values("generator in (maze, \"a b\", 7)"),
            (std::vector<std::string>{"maze", "a b", "7"}));
  EXPECT_EQ(values("id = 73f8d0"), std::vector<std::string>{"73f8d0"});
  EXPECT_EQ(values("id = 1e5"), std::vector<std::string>{"1e5"}) << "not as a number";
  EXPECT_TRUE(as<Node::Matches>(parse("name glob 'a*'")).glob);
  EXPECT_FALSE(as<Node::Matches>(parse("name LIKE 'a%'")).glob);
}

TEST(Selection, RangesOfIndexesAreCountedFromNought) {
  EXPECT_EQ(as<Node::InRange>(parse("by_density[2]")).range, 2U);
  EXPECT_EQ(refusal("by_density[3]"),
            "selection, character 12: '3' is no range of 'by_density'; expected 0 to 2");
  EXPECT_EQ(refusal("by_density[0.5]"),
            "selection, character 12: '0.5' is no range of 'by_density'; expected 0 to 2");
  EXPECT_EQ(refusal("by_density = 1"),
            "selection, character 12: '=' is not what belongs here; expected '[' and the number of "
            "a range");
}

TEST(Selection, MistakesAreToldWithTheirPlaceAndWhatWasExpected) {
  EXPECT_EQ(refusal("density >= 0.1 and clernes < 1"),
            "selection, character 20: 'clernes' is no field; expected 'clearness'");
  EXPECT_EQ(refusal("density >"),
            "selection, character 10: the end is not what belongs here; expected a number or a "
            "field");
  EXPECT_EQ(refusal("density 0.1"),
            "selection, character 9: '0.1' is not what belongs here; expected a comparison "
            "(< <= > >= = !=), 'in', 'between' or 'is'");
  EXPECT_EQ(refusal("(density > 1"),
            "selection, character 13: the end is not what belongs here; expected ')'");
  EXPECT_EQ(refusal("density > 1 density > 2"),
            "selection, character 13: 'density' is not what belongs here; expected 'and', 'or', or "
            "the end");
  EXPECT_EQ(
      refusal("name < b"),
      "selection, character 6: 'name' is a text, not followed by '<'; expected one of = != in "
      "like glob is");
  EXPECT_EQ(refusal("name = 'half"),
            "selection, character 8: a quoted text has no end; expected '");
  EXPECT_EQ(refusal("density in [2, 1]"),
            "selection, character 12: is no interval; expected two numbers, the lower one first");
  EXPECT_EQ(
      refusal("density > 1; drop table scenarios"),
      "selection, character 12: ';' means nothing here; expected a field, a number, a text in "
      "quotes, or one of < <= > >= = != ( ) [ ] ,");
  EXPECT_EQ(refusal(""),
            "selection, character 1: the end is not what belongs here; expected a field, a number, "
            "'not' or '('");
  EXPECT_EQ(refusal("density = name"),
            "selection, character 11: 'name' is not what belongs here; expected a field with a "
            "number");
}

TEST(Selection, WhatWouldOverwhelmIsRefused) {
  std::string deep, wide = "density > 0";
  for (int i = 0; i < 5000; ++i) deep += "(";
  for (int i = 0; i < 500; ++i) wide += " or density > 0";
  EXPECT_NE(refusal(deep).find("nested too deeply"), std::string::npos);
  EXPECT_NE(refusal(wide).find("too many conditions"), std::string::npos);
  EXPECT_NE(refusal(std::string(1000000, '(')).find("too long"), std::string::npos);
}

TEST(Selection, OrdersNameFieldsAndDirections) {
  const auto orders = parse_selection_order("density desc, name, clearness ASC", kVocabulary);
  ASSERT_EQ(orders.size(), 3U);
  EXPECT_EQ(orders[0].field, "density");
  EXPECT_TRUE(orders[0].descending);
  EXPECT_FALSE(orders[1].descending);
  EXPECT_FALSE(orders[2].descending);
  EXPECT_EQ(error_text(Culprit::Usage, [] { parse_selection_order("densty", kVocabulary); }),
            "selection, character 1: 'densty' is no field; expected 'density'");
  EXPECT_NE(error_text(Culprit::Usage, [] { parse_selection_order("density up", kVocabulary); })
                .find("character 9"),
            std::string::npos);
}

TEST(Selection, KnowsTheNumbersItSpeaksOf) {
  const SelectionPtr selection =
      parse("clearness < density and name = density and tag is na and confinement is not na");
  EXPECT_EQ(number_fields(selection, kVocabulary),
            (std::vector<std::string>{"clearness", "confinement", "density"}));
  EXPECT_TRUE(number_fields(nullptr, kVocabulary).empty());
}

}  // namespace
}  // namespace slalom
