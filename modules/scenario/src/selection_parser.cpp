#include "selection_parser.h"

#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

// SQLite refuses deeper and larger expressions with a message that tells users nothing.
constexpr std::size_t kDeepest = 100;
constexpr std::size_t kMostConditions = 400;

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

SelectionPtr SelectionParser::whole() {
  SelectionPtr selection = disjunction();
  if (now().kind != SelectionToken::Kind::End) throw unexpected("'and', 'or', or the end");
  return selection;
}

SelectionPtr SelectionParser::disjunction() {
  std::vector<SelectionPtr> parts = {conjunction()};
  while (take_key_word("or")) parts.push_back(conjunction());
  return joined(Node::Connective::Or, std::move(parts));
}

SelectionPtr SelectionParser::conjunction() {
  std::vector<SelectionPtr> parts = {negation()};
  while (take_key_word("and")) parts.push_back(negation());
  return joined(Node::Connective::And, std::move(parts));
}

SelectionPtr SelectionParser::negation() {
  if (++depth_ > kDeepest)
    throw selection_error(now().position, "is nested too deeply",
                          std::to_string(kDeepest) + " levels at most");
  SelectionPtr selection;
  if (take_key_word("not")) {
    selection = negated(negation(), true);
  } else if (take_symbol("(")) {
    selection = disjunction();
    expect_symbol(")");
  } else {
    selection = condition();
  }
  --depth_;
  return selection;
}

SelectionPtr SelectionParser::condition() {
  const SelectionToken token = take();
  if (token.kind == SelectionToken::Kind::Number) return comparison(token.number);
  if (token.kind != SelectionToken::Kind::Word) {
    if (token.kind != SelectionToken::Kind::End) --at_;
    throw unexpected("a field, a number, 'not' or '('");
  }
  if (now().is_symbol("[") && vocabulary_.indexes.count(token.text) > 0)
    return index_condition(token.text);
  if (knows_number(token.text)) return number_condition(token.text);
  if (knows_text(token.text)) return text_condition(token.text);
  if (vocabulary_.indexes.count(token.text) > 0) throw unexpected("'[' and the number of a range");
  throw unknown_field(token);
}

SelectionPtr SelectionParser::number_condition(const SelectionOperand& left) {
  const SelectionPtr special = field_condition(std::get<std::string>(left));
  return special ? special : comparison(left);
}

SelectionPtr SelectionParser::field_condition(const std::string& field) {
  if (take_key_word("is")) {
    const bool negate = take_key_word("not");
    expect_key_word("na");
    return negated(node(Node::IsNa{field}), negate);
  }
  const bool negate = take_key_word("not");
  if (take_key_word("in")) return negated(numbers_after_in(field), negate);
  if (take_key_word("between")) return negated(between(field), negate);
  if (negate) throw unexpected("'in' or 'between'");
  return nullptr;
}

SelectionPtr SelectionParser::comparison(const SelectionOperand& left) {
  const char* const kExpected = "a comparison (< <= > >= = !=), 'in', 'between' or 'is'";
  const auto how = take_comparison();
  if (!how) throw unexpected(kExpected);
  const SelectionOperand middle = operand();
  SelectionPtr first = node(Node::Compare{left, *how, middle});
  const auto then = take_comparison();
  if (!then) return first;
  SelectionPtr second = node(Node::Compare{middle, *then, operand()});
  return joined(Node::Connective::And, {first, second});
}

SelectionPtr SelectionParser::numbers_after_in(const std::string& field) {
  const bool low_open = now().is_symbol("(");
  if (!low_open && !now().is_symbol("[")) throw unexpected("'(' or '['");
  const std::size_t begin = take().position;
  std::vector<double> values = {number()};
  while (take_symbol(",")) values.push_back(number());
  const bool high_open = take_symbol(")");
  if (!high_open) expect_symbol("]");
  if (low_open && high_open) return node(Node::AmongNumbers{field, values});
  if (values.size() != 2 || !(values[0] <= values[1]))
    throw selection_error(begin, "is no interval", "two numbers, the lower one first");
  return node(Node::Within{field, values[0], values[1], low_open, high_open});
}

SelectionPtr SelectionParser::between(const std::string& field) {
  const double low = number();
  expect_key_word("and");
  return node(Node::Within{field, low, number(), false, false});
}

SelectionPtr SelectionParser::text_condition(const std::string& field) {
  if (take_key_word("is")) {
    const bool negate = take_key_word("not");
    expect_key_word("na");
    return negated(node(Node::IsNa{field}), negate);
  }
  const bool negate = take_key_word("not");
  if (take_key_word("in")) return negated(texts_after_in(field), negate);
  for (const bool glob : {false, true})
    if (take_key_word(glob ? "glob" : "like"))
      return negated(node(Node::Matches{field, text(), glob}), negate);
  if (negate) throw unexpected("'in', 'like' or 'glob'");
  const SelectionToken token = now();
  const auto how = take_comparison();
  if (how == Comparison::Equal || how == Comparison::NotEqual)
    return negated(node(Node::AmongTexts{field, {text()}}), how == Comparison::NotEqual);
  throw selection_error(token.position,
                        "'" + field + "' is a text, not followed by " + token.shown(),
                        "one of = != in like glob is");
}

SelectionPtr SelectionParser::texts_after_in(const std::string& field) {
  expect_symbol("(");
  std::vector<std::string> values = {text()};
  while (take_symbol(",")) values.push_back(text());
  expect_symbol(")");
  return node(Node::AmongTexts{field, values});
}

SelectionPtr SelectionParser::index_condition(const std::string& index) {
  expect_symbol("[");
  const SelectionToken token = now();
  const double range = number();
  const std::size_t count = vocabulary_.indexes.at(index);
  if (!(range >= 0) || range >= static_cast<double>(count) ||
      range != static_cast<double>(static_cast<std::size_t>(range)))
    throw selection_error(token.position, token.shown() + " is no range of '" + index + "'",
                          "0 to " + std::to_string(count - 1));
  expect_symbol("]");
  return node(Node::InRange{index, static_cast<std::size_t>(range)});
}

std::vector<SelectionOrder> SelectionParser::whole_order() {
  std::vector<SelectionOrder> orders;
  do {
    SelectionOrder order{field("a field to order by"), false};
    order.descending = take_key_word("desc");
    if (!order.descending) take_key_word("asc");
    orders.push_back(order);
  } while (take_symbol(","));
  if (now().kind != SelectionToken::Kind::End) throw unexpected("'asc', 'desc', ',' or the end");
  return orders;
}

bool SelectionParser::take_symbol(const char* symbol) {
  const bool there = now().is_symbol(symbol);
  if (there) take();
  return there;
}

bool SelectionParser::take_key_word(const char* word) {
  const bool there = now().is_key_word(word);
  if (there) take();
  return there;
}

void SelectionParser::expect_symbol(const char* symbol) {
  if (!take_symbol(symbol)) throw unexpected("'" + std::string(symbol) + "'");
}

void SelectionParser::expect_key_word(const char* word) {
  if (!take_key_word(word)) throw unexpected("'" + std::string(word) + "'");
}

bool SelectionParser::knows_number(const std::string& name) const {
  return has(vocabulary_.numbers, name);
}

bool SelectionParser::knows_text(const std::string& name) const {
  return has(vocabulary_.texts, name);
}

std::string SelectionParser::field(const char* expected) {
  if (now().kind != SelectionToken::Kind::Word) throw unexpected(expected);
  const SelectionToken token = take();
  if (!knows_number(token.text) && !knows_text(token.text)) throw unknown_field(token);
  return token.text;
}

double SelectionParser::number() {
  if (now().kind != SelectionToken::Kind::Number) throw unexpected("a number");
  return take().number;
}

SelectionOperand SelectionParser::operand() {
  if (now().kind == SelectionToken::Kind::Number) return take().number;
  if (now().kind != SelectionToken::Kind::Word) throw unexpected("a number or a field");
  if (!knows_number(now().text)) {
    if (knows_text(now().text)) throw unexpected("a field with a number");
    throw unknown_field(now());
  }
  return take().text;
}

std::string SelectionParser::text() {
  const auto kind = now().kind;
  if (kind == SelectionToken::Kind::Symbol || kind == SelectionToken::Kind::End)
    throw unexpected("a text");
  return take().text;
}

std::optional<Comparison> SelectionParser::take_comparison() {
  static const std::pair<const char*, Comparison> kAll[] = {
      {"<", Comparison::Less},          {"<=", Comparison::LessEqual}, {">", Comparison::Greater},
      {">=", Comparison::GreaterEqual}, {"=", Comparison::Equal},      {"==", Comparison::Equal},
      {"!=", Comparison::NotEqual},     {"<>", Comparison::NotEqual}};
  for (const auto& [symbol, comparison] : kAll)
    if (take_symbol(symbol)) return comparison;
  return std::nullopt;
}

SelectionPtr SelectionParser::node(decltype(Node::what) what) {
  if (++nodes_ > kMostConditions)
    throw selection_error(now().position, "has too many conditions",
                          std::to_string(kMostConditions) + " at most");
  return std::make_shared<const Node>(Node{std::move(what)});
}

SelectionPtr SelectionParser::negated(SelectionPtr part, bool negate) {
  if (!negate) return part;
  return node(Node::Joined{Node::Connective::Not, {std::move(part)}});
}

SelectionPtr SelectionParser::joined(Node::Connective how, std::vector<SelectionPtr> parts) {
  if (parts.size() == 1) return parts.front();
  return node(Node::Joined{how, std::move(parts)});
}

Error SelectionParser::unexpected(const std::string& expected) const {
  return selection_error(now().position, now().shown() + " is not what belongs here", expected);
}

Error SelectionParser::unknown_field(const SelectionToken& token) const {
  std::vector<std::string> known = vocabulary_.numbers;
  known.insert(known.end(), vocabulary_.texts.begin(), vocabulary_.texts.end());
  for (const auto& [name, ranges] : vocabulary_.indexes) known.push_back(name);
  const std::string nearest = nearest_name(token.text, known);
  return selection_error(token.position, token.shown() + " is no field",
                         nearest.empty() ? "one of " + join(known, ", ") : "'" + nearest + "'");
}

}  // namespace slalom
