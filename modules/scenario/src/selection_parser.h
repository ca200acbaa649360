#pragma once

#include "selection_lexer.h"

#include <slalom/scenario/selection.h>

namespace slalom {

/// Recursive descent over the tokens of one selection expression.
class SelectionParser {
 public:
  SelectionParser(std::vector<SelectionToken> tokens, const SelectionVocabulary& vocabulary)
      : tokens_(std::move(tokens)), vocabulary_(vocabulary) {}

  SelectionPtr whole();
  std::vector<SelectionOrder> whole_order();

 private:
  using Node = SelectionNode;

  SelectionPtr disjunction();
  SelectionPtr conjunction();
  SelectionPtr negation();
  SelectionPtr condition();
  SelectionPtr number_condition(const SelectionOperand& left);
  SelectionPtr field_condition(const std::string& field);  ///< null when none of these
  SelectionPtr comparison(const SelectionOperand& left);
  SelectionPtr text_condition(const std::string& field);
  SelectionPtr index_condition(const std::string& index);
  SelectionPtr numbers_after_in(const std::string& field);
  SelectionPtr between(const std::string& field);
  SelectionPtr texts_after_in(const std::string& field);

  const SelectionToken& now() const { return tokens_[at_]; }
  SelectionToken take() { return tokens_[at_ + 1 < tokens_.size() ? at_++ : at_]; }
  bool take_symbol(const char* symbol);
  bool take_key_word(const char* word);
  void expect_symbol(const char* symbol);
  void expect_key_word(const char* word);
  bool knows_number(const std::string& name) const;
  bool knows_text(const std::string& name) const;
  std::string field(const char* expected);  ///< of any kind
  double number();
  SelectionOperand operand();
  std::string text();
  std::optional<Comparison> take_comparison();
  SelectionPtr node(decltype(Node::what) what);
  SelectionPtr negated(SelectionPtr part, bool negate);
  SelectionPtr joined(Node::Connective how, std::vector<SelectionPtr> parts);
  Error unexpected(const std::string& expected) const;
  Error unknown_field(const SelectionToken& token) const;

  std::vector<SelectionToken> tokens_;
  const SelectionVocabulary& vocabulary_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0, nodes_ = 0;
};

}  // namespace slalom
