// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "selection_lexer.h"

#include <slalom/scenario/selection.h>

namespace slalom {

/// Recursive descent over the tokens of one selection expression.
class SelectionParser {
 public:
  SelectionParser(std::vector<SelectionToken> tokens, const SelectionVocabulary& vocabulary)
      : tokens_(std::move(tokens)), vocabulary_(vocabulary) {}

  SelectionPtr parse_expression();
  std::vector<SelectionOrder> parse_order();

 private:
  using Node = SelectionNode;

  SelectionPtr disjunction();
  SelectionPtr conjunction();
  SelectionPtr negation();
  SelectionPtr condition();
  SelectionPtr number_condition(const SelectionOperand& left);
  SelectionPtr field_condition(const std::string& field);  ///< null if there is no such condition
  SelectionPtr comparison(const SelectionOperand& left);
  SelectionPtr text_condition(const std::string& field);
  SelectionPtr index_condition(const std::string& index);
  SelectionPtr numbers_after_in(const std::string& field);
  SelectionPtr between(const std::string& field);
  SelectionPtr texts_after_in(const std::string& field);

  const SelectionToken& current() const { return tokens_[at_]; }
  /// Takes a field that is called by its name, or in quotes; none if the tokens are not one.
  std::optional<SelectionToken> accept_field_name();
  SelectionToken take() { return tokens_[at_ + 1 < tokens_.size() ? at_++ : at_]; }
  bool accept_symbol(const char* symbol);
  bool accept_keyword(const char* word);
  void expect_symbol(const char* symbol);
  void expect_keyword(const char* word);
  bool is_number_field(const std::string& name) const;
  bool is_text_field(const std::string& name) const;
  std::string field(const char* expected);  ///< of any kind
  double number();
  SelectionOperand operand();
  std::string text();
  std::optional<Comparison> accept_comparison();
  SelectionPtr node(decltype(Node::what) what);
  SelectionPtr negated(SelectionPtr part, bool negate);
  SelectionPtr compound(Node::Connective op, std::vector<SelectionPtr> parts);
  Error unexpected(const std::string& expected) const;
  Error unknown_field(const SelectionToken& token) const;

  std::vector<SelectionToken> tokens_;
  const SelectionVocabulary& vocabulary_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0, nodes_ = 0;
};

}  // namespace slalom
