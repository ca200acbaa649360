// SPDX-License-Identifier: BSD-3-Clause
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

/// Whether `text` is refused at a character (from 1) with these words.
::testing::AssertionResult refused(const std::string& text, int character,
                                   std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::Usage, "selection, character " + std::to_string(character) + ": ",
                      words, [&] { parse(text); });
}

template <typename What>
What as(const SelectionPtr& selection) {
  return std::get<What>(selection->what);
}

TEST(Selection, AndBindsCloserThanOr) {
  const SelectionPtr selection = parse("density > 1 or density > 2 and density > 3");
  const auto disjunction = as<Node::Compound>(selection);
  ASSERT_EQ(disjunction.op, Node::Connective::Or);
  ASSERT_EQ(disjunction.parts.size(), 2U);
  EXPECT_EQ(as<Node::Compare>(disjunction.parts[0]).right, SelectionOperand(1.0));
  EXPECT_EQ(as<Node::Compound>(disjunction.parts[1]).op, Node::Connective::And);
  const auto conjunction =
      as<Node::Compound>(parse("(density > 1 or density > 2) and density > 3"));
  EXPECT_EQ(conjunction.op, Node::Connective::And);
}

TEST(Selection, NotBindsClosest) {
  const auto conjunction =
      as<Node::Compound>(parse("not density > 1 and not (tag = a or tag = b)"));
  ASSERT_EQ(conjunction.op, Node::Connective::And);
  for (const SelectionPtr& part : conjunction.parts)
    EXPECT_EQ(as<Node::Compound>(part).op, Node::Connective::Not);
}

TEST(Selection, NumbersMayBeOnEitherSide) {
  const auto compare = as<Node::Compare>(parse("-1.5e-3 <= density"));
  EXPECT_EQ(compare.left, SelectionOperand(-1.5e-3));
  EXPECT_EQ(compare.op, Comparison::LessEqual);
  EXPECT_EQ(compare.right, SelectionOperand(std::string("density")));
  EXPECT_EQ(as<Node::Compare>(parse("density<clearness")).right,
            SelectionOperand(std::string("clearness")));
  const auto chain = as<Node::Compound>(parse("0.1 <= density < 0.2"));
  EXPECT_EQ(as<Node::Compare>(chain.parts[1]).right, SelectionOperand(0.2));
}

TEST(Selection, IntervalsAreOpenOrClosedAtEachEnd) {
  const auto ends = [](const std::string& text) {
    const SelectionPtr selection = parse(text);
    const auto w = as<Node::Within>(selection);
    return std::make_tuple(w.low, w.low_open, w.high, w.high_open);
  };
  EXPECT_EQ(ends("density between 1 and 2"), std::make_tuple(1.0, false, 2.0, false));
  EXPECT_EQ(ends("density in [1, 2]"), std::make_tuple(1.0, false, 2.0, false));
  EXPECT_EQ(ends("density in [1, 2)"), std::make_tuple(1.0, false, 2.0, true));
  EXPECT_EQ(ends("density in (1, 2]"), std::make_tuple(1.0, true, 2.0, false));
  EXPECT_EQ(as<Node::NumberInSet>(parse("density in (1, 2)")).values, (std::vector<double>{1, 2}));
}

TEST(Selection, TextsMayBeQuotedOrNot) {
  const auto values = [](const std::string& text) {
    return as<Node::TextInSet>(parse(text)).values;
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

TEST(Selection, FieldsMayBeCalledByTheirNames) {
  SelectionVocabulary named = kVocabulary;
  name_field(named, "Mean clearance", "clearness");
  name_field(named, "Confinement, 5 % quantile", "confinement");
  name_field(named, "Density", "density");
  const auto fields = [&](const std::string& text) {
    return used_fields(parse_selection(text, named));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(fields("mean Clearance > 1"), Names{"clearness"});
  EXPECT_EQ(fields("0.1 <= Density < mean clearance"), (Names{"clearness", "density"}));
  EXPECT_EQ(fields("density > mean clearance and name = 'mean clearance'"),
            (Names{"clearness", "density", "name"}));
  EXPECT_EQ(fields("\"Confinement, 5 % quantile\" in [0, 1)"), Names{"confinement"});
  EXPECT_EQ(fields("'density' is na"), Names{"density"});
  EXPECT_EQ(parse_selection_order("mean clearance desc, name", named)[0].field, "clearness");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "selection, character 1: ", {"'mean'"},
                           [&] { fields("mean density > 1"); }));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "selection, character 1: ", {"'no field'"},
                           [&] { fields("'no field' > 1"); }));
}

TEST(Selection, RangesOfIndexesAreCountedFromZero) {
  EXPECT_EQ(as<Node::InRange>(parse("by_density[2]")).range, 2U);
  EXPECT_TRUE(refused("by_density[3]", 12, {"'3'", "range of 'by_density'", "expected 0 to 2"}));
  EXPECT_TRUE(
      refused("by_density[0.5]", 12, {"'0.5'", "range of 'by_density'", "expected 0 to 2"}));
  EXPECT_TRUE(refused("by_density = 1", 12, {"'='", "expected '['", "range"}));
}

TEST(Selection, ErrorsHaveTheirPositionAndWhatWasExpected) {
  EXPECT_TRUE(refused("density >= 0.1 and clernes < 1", 20,
                      {"field", "'clernes'", "expected 'clearness'"}));
  EXPECT_TRUE(refused("density >", 10, {"end", "expected a number or a field"}));
  EXPECT_TRUE(
      refused("density 0.1", 9,
              {"'0.1'", "expected a comparison (< <= > >= = !=)", "'in'", "'between'", "'is'"}));
  EXPECT_TRUE(refused("(density > 1", 13, {"end", "expected ')'"}));
  EXPECT_TRUE(
      refused("density > 1 density > 2", 13, {"'density'", "expected 'and', 'or', or the end"}));
  EXPECT_TRUE(
      refused("name < b", 6, {"'name'", "text", "'<'", "expected one of = != in like glob is"}));
  EXPECT_TRUE(refused("name = 'half", 8, {"quoted text", "expected '"}));
  EXPECT_TRUE(
      refused("density in [2, 1]", 12, {"interval", "expected two numbers, the lower one first"}));
  EXPECT_TRUE(refused(
      "density > 1; drop table scenarios", 12,
      {"';'", "expected a field, a number, a text in quotes", "one of < <= > >= = != ( ) [ ] ,"}));
  EXPECT_TRUE(refused("", 1, {"end", "expected a field, a number, 'not' or '('"}));
  EXPECT_TRUE(refused("density = name", 11, {"'name'", "expected a field with a number"}));
}

TEST(Selection, TooLargeExpressionsAreRefused) {
  std::string deep, wide = "density > 0";
  for (int i = 0; i < 5000; ++i) deep += "(";
  for (int i = 0; i < 500; ++i) wide += " or density > 0";
  const auto refused_with = [](const std::string& text, const std::string& words) {
    return throws_error(ErrorKind::Usage, "selection, character ", {words}, [&] { parse(text); });
  };
  EXPECT_TRUE(refused_with(deep, "nested too deeply"));
  EXPECT_TRUE(refused_with(wide, "too many conditions"));
  EXPECT_TRUE(refused_with(std::string(1000000, '('), "too long"));
}

TEST(Selection, OrdersHaveFieldsAndDirections) {
  const auto orders = parse_selection_order("density desc, name, clearness ASC", kVocabulary);
  ASSERT_EQ(orders.size(), 3U);
  EXPECT_EQ(orders[0].field, "density");
  EXPECT_TRUE(orders[0].descending);
  EXPECT_FALSE(orders[1].descending);
  EXPECT_FALSE(orders[2].descending);
  const auto refused_order = [](const std::string& text, const std::string& where,
                                std::initializer_list<std::string> words) {
    return throws_error(ErrorKind::Usage, where, words,
                        [&] { parse_selection_order(text, kVocabulary); });
  };
  EXPECT_TRUE(
      refused_order("densty", "selection, character 1: ", {"'densty'", "expected 'density'"}));
  EXPECT_TRUE(refused_order("density up", "selection, character 9: ", {"'up'"}));
}

TEST(Selection, NumberFieldsAreCollected) {
  const SelectionPtr selection =
      parse("clearness < density and name = density and tag is na and confinement is not na");
  EXPECT_EQ(number_fields(selection, kVocabulary),
            (std::vector<std::string>{"clearness", "confinement", "density"}));
  EXPECT_TRUE(number_fields(nullptr, kVocabulary).empty());
}

}  // namespace
}  // namespace slalom
