// SPDX-License-Identifier: BSD-3-Clause
#include "selection_parser.h"

#include <slalom/core/text.h>

namespace slalom {
namespace {

// SQLite refuses deeper and larger expressions with an unhelpful message.
constexpr std::size_t kMaxDepth = 100;
constexpr std::size_t kMaxConditions = 400;
constexpr std::size_t kMaxNameWords = 8;

}  // namespace

SelectionPtr SelectionParser::parse_expression() {
  SelectionPtr selection = disjunction();
  if (current().kind != SelectionToken::Kind::End) throw unexpected("'and', 'or', or the end");
  return selection;
}

SelectionPtr SelectionParser::disjunction() {
  std::vector<SelectionPtr> parts = {conjunction()};
  while (accept_keyword("or")) parts.push_back(conjunction());
  return compound(Node::Connective::Or, std::move(parts));
}

SelectionPtr SelectionParser::conjunction() {
  std::vector<SelectionPtr> parts = {negation()};
  while (accept_keyword("and")) parts.push_back(negation());
  return compound(Node::Connective::And, std::move(parts));
}

SelectionPtr SelectionParser::negation() {
  if (++depth_ > kMaxDepth)
    throw selection_error(current().position, "expression is nested too deeply",
                          "at most " + std::to_string(kMaxDepth) + " levels");
  SelectionPtr selection;
  if (accept_keyword("not")) {
    selection = negated(negation(), true);
  } else if (accept_symbol("(")) {
    selection = disjunction();
    expect_symbol(")");
  } else {
    selection = condition();
  }
  --depth_;
  return selection;
}

SelectionPtr SelectionParser::condition() {
  const std::optional<SelectionToken> named = accept_field_name();
  const SelectionToken token = named ? *named : take();
  if (token.kind == SelectionToken::Kind::Number) return comparison(token.number);
  if (token.kind != SelectionToken::Kind::Word) {
    if (token.kind != SelectionToken::Kind::End) --at_;
    throw unexpected("a field, a number, 'not' or '('");
  }
  if (current().is_symbol("[") && vocabulary_.indexes.count(token.text) > 0)
    return index_condition(token.text);
  if (is_number_field(token.text)) return number_condition(token.text);
  if (is_text_field(token.text)) return text_condition(token.text);
  if (vocabulary_.indexes.count(token.text) > 0) throw unexpected("'[' and the number of a range");
  throw unknown_field(token);
}

SelectionPtr SelectionParser::number_condition(const SelectionOperand& left) {
  const SelectionPtr special = field_condition(std::get<std::string>(left));
  return special ? special : comparison(left);
}

SelectionPtr SelectionParser::field_condition(const std::string& field) {
  if (accept_keyword("is")) {
    const bool negate = accept_keyword("not");
    expect_keyword("na");
    return negated(node(Node::IsNa{field}), negate);
  }
  const bool negate = accept_keyword("not");
  if (accept_keyword("in")) return negated(numbers_after_in(field), negate);
  if (accept_keyword("between")) return negated(between(field), negate);
  if (negate) throw unexpected("'in' or 'between'");
  return nullptr;
}

SelectionPtr SelectionParser::comparison(const SelectionOperand& left) {
  const char* const kExpected = "a comparison (< <= > >= = !=), 'in', 'between' or 'is'";
  const auto op = accept_comparison();
  if (!op) throw unexpected(kExpected);
  const SelectionOperand middle = operand();
  SelectionPtr first = node(Node::Compare{left, *op, middle});
  const auto then = accept_comparison();
  if (!then) return first;
  SelectionPtr second = node(Node::Compare{middle, *then, operand()});
  return compound(Node::Connective::And, {first, second});
}

SelectionPtr SelectionParser::numbers_after_in(const std::string& field) {
  const bool low_open = current().is_symbol("(");
  if (!low_open && !current().is_symbol("[")) throw unexpected("'(' or '['");
  const std::size_t begin = take().position;
  std::vector<double> values = {number()};
  while (accept_symbol(",")) values.push_back(number());
  const bool high_open = accept_symbol(")");
  if (!high_open) expect_symbol("]");
  if (low_open && high_open) return node(Node::NumberInSet{field, values});
  if (values.size() != 2 || !(values[0] <= values[1]))
    throw selection_error(begin, "invalid interval", "two numbers, the lower one first");
  return node(Node::Within{field, values[0], values[1], low_open, high_open});
}

SelectionPtr SelectionParser::between(const std::string& field) {
  const double low = number();
  expect_keyword("and");
  return node(Node::Within{field, low, number(), false, false});
}

SelectionPtr SelectionParser::text_condition(const std::string& field) {
  if (accept_keyword("is")) {
    const bool negate = accept_keyword("not");
    expect_keyword("na");
    return negated(node(Node::IsNa{field}), negate);
  }
  const bool negate = accept_keyword("not");
  if (accept_keyword("in")) return negated(texts_after_in(field), negate);
  for (const bool glob : {false, true})
    if (accept_keyword(glob ? "glob" : "like"))
      return negated(node(Node::Matches{field, text(), glob}), negate);
  if (negate) throw unexpected("'in', 'like' or 'glob'");
  const SelectionToken token = current();
  const auto op = accept_comparison();
  if (op == Comparison::Equal || op == Comparison::NotEqual)
    return negated(node(Node::TextInSet{field, {text()}}), op == Comparison::NotEqual);
  throw selection_error(token.position,
                        token.quoted_text() + " is invalid after the text field '" + field + "'",
                        "one of = != in like glob is");
}

SelectionPtr SelectionParser::texts_after_in(const std::string& field) {
  expect_symbol("(");
  std::vector<std::string> values = {text()};
  while (accept_symbol(",")) values.push_back(text());
  expect_symbol(")");
  return node(Node::TextInSet{field, values});
}

SelectionPtr SelectionParser::index_condition(const std::string& index) {
  expect_symbol("[");
  const SelectionToken token = current();
  const double range = number();
  const std::size_t count = vocabulary_.indexes.at(index);
  if (!(range >= 0) || range >= static_cast<double>(count) ||
      range != static_cast<double>(static_cast<std::size_t>(range)))
    throw selection_error(token.position,
                          token.quoted_text() + " is not a range of '" + index + "'",
                          "0 to " + std::to_string(count - 1));
  expect_symbol("]");
  return node(Node::InRange{index, static_cast<std::size_t>(range)});
}

std::vector<SelectionOrder> SelectionParser::parse_order() {
  std::vector<SelectionOrder> orders;
  do {
    SelectionOrder order{field("a field to order by"), false};
    order.descending = accept_keyword("desc");
    if (!order.descending) accept_keyword("asc");
    orders.push_back(order);
  } while (accept_symbol(","));
  if (current().kind != SelectionToken::Kind::End)
    throw unexpected("'asc', 'desc', ',' or the end");
  return orders;
}

bool SelectionParser::accept_symbol(const char* symbol) {
  const bool there = current().is_symbol(symbol);
  if (there) take();
  return there;
}

bool SelectionParser::accept_keyword(const char* word) {
  const bool there = current().is_keyword(word);
  if (there) take();
  return there;
}

void SelectionParser::expect_symbol(const char* symbol) {
  if (!accept_symbol(symbol)) throw unexpected("'" + std::string(symbol) + "'");
}

void SelectionParser::expect_keyword(const char* word) {
  if (!accept_keyword(word)) throw unexpected("'" + std::string(word) + "'");
}

bool SelectionParser::is_number_field(const std::string& name) const {
  return contains(vocabulary_.numbers, name);
}

bool SelectionParser::is_text_field(const std::string& name) const {
  return contains(vocabulary_.texts, name);
}

std::string SelectionParser::field(const char* expected) {
  if (const auto named = accept_field_name()) return named->text;
  if (current().kind != SelectionToken::Kind::Word) throw unexpected(expected);
  const SelectionToken token = take();
  if (!is_number_field(token.text) && !is_text_field(token.text)) throw unknown_field(token);
  return token.text;
}

double SelectionParser::number() {
  if (current().kind != SelectionToken::Kind::Number) throw unexpected("a number");
  return take().number;
}

std::optional<SelectionToken> SelectionParser::accept_field_name() {
  const SelectionToken first = current();
  std::string words;
  std::optional<SelectionToken> found;
  std::size_t end = at_;
  for (std::size_t at = at_; at < tokens_.size() && at < at_ + kMaxNameWords; ++at) {
    const bool quoted = tokens_[at].kind == SelectionToken::Kind::Quoted;
    if ((quoted && at > at_) || (!quoted && tokens_[at].kind != SelectionToken::Kind::Word)) break;
    words += (at > at_ ? " " : "") + lower_case(tokens_[at].text);
    if (const auto known = vocabulary_.names.find(words); known != vocabulary_.names.end()) {
      found = SelectionToken{SelectionToken::Kind::Word, known->second, 0, first.position};
      end = at + 1;
    } else if (quoted && (is_number_field(first.text) || is_text_field(first.text))) {
      found = SelectionToken{SelectionToken::Kind::Word, first.text, 0, first.position};
      end = at + 1;
    }
    if (quoted) break;
  }
  at_ = end;
  return found;
}

SelectionOperand SelectionParser::operand() {
  const std::size_t begin = at_;
  if (const auto named = accept_field_name(); named && is_number_field(named->text))
    return named->text;
  at_ = begin;
  if (current().kind == SelectionToken::Kind::Number) return take().number;
  if (current().kind != SelectionToken::Kind::Word) throw unexpected("a number or a field");
  if (!is_number_field(current().text)) {
    if (is_text_field(current().text)) throw unexpected("a field with a number");
    throw unknown_field(current());
  }
  return take().text;
}

std::string SelectionParser::text() {
  const auto kind = current().kind;
  if (kind == SelectionToken::Kind::Symbol || kind == SelectionToken::Kind::End)
    throw unexpected("a text");
  return take().text;
}

std::optional<Comparison> SelectionParser::accept_comparison() {
  for (const Comparison comparison : enum_values<Comparison>())
    if (accept_symbol(to_string(comparison).c_str())) return comparison;
  if (accept_symbol("==")) return Comparison::Equal;
  if (accept_symbol("!=")) return Comparison::NotEqual;
  return std::nullopt;
}

SelectionPtr SelectionParser::node(decltype(Node::what) what) {
  if (++nodes_ > kMaxConditions)
    throw selection_error(current().position, "too many conditions",
                          "at most " + std::to_string(kMaxConditions));
  return std::make_shared<const Node>(Node{std::move(what)});
}

SelectionPtr SelectionParser::negated(SelectionPtr part, bool negate) {
  if (!negate) return part;
  return node(Node::Compound{Node::Connective::Not, {std::move(part)}});
}

SelectionPtr SelectionParser::compound(Node::Connective op, std::vector<SelectionPtr> parts) {
  if (parts.size() == 1) return parts.front();
  return node(Node::Compound{op, std::move(parts)});
}

Error SelectionParser::unexpected(const std::string& expected) const {
  return selection_error(current().position, "unexpected " + current().quoted_text(), expected);
}

Error SelectionParser::unknown_field(const SelectionToken& token) const {
  std::vector<std::string> known = vocabulary_.numbers;
  known.insert(known.end(), vocabulary_.texts.begin(), vocabulary_.texts.end());
  for (const auto& [name, ranges] : vocabulary_.indexes) known.push_back(name);
  return selection_error(token.position, "unknown field " + token.quoted_text(),
                         expected_name(token.text, known));
}

}  // namespace slalom
