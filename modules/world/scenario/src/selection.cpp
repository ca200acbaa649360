// SPDX-License-Identifier: BSD-3-Clause
#include "selection_parser.h"

#include <slalom/core/text.h>
#include <slalom/scenario/selection.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

using Node = SelectionNode;

void collect(const Node& node, std::set<std::string>& fields) {
  if (const auto* compound = std::get_if<Node::Compound>(&node.what)) {
    for (const SelectionPtr& part : compound->parts) collect(*part, fields);
  } else if (const auto* compare = std::get_if<Node::Compare>(&node.what)) {
    for (const SelectionOperand* side : {&compare->left, &compare->right})
      if (const auto* field = std::get_if<std::string>(side)) fields.insert(*field);
  } else if (const auto* within = std::get_if<Node::Within>(&node.what)) {
    fields.insert(within->field);
  } else if (const auto* among = std::get_if<Node::NumberInSet>(&node.what)) {
    fields.insert(among->field);
  } else if (const auto* na = std::get_if<Node::IsNa>(&node.what)) {
    fields.insert(na->field);
  } else if (const auto* texts = std::get_if<Node::TextInSet>(&node.what)) {
    fields.insert(texts->field);
  } else if (const auto* matches = std::get_if<Node::Matches>(&node.what)) {
    fields.insert(matches->field);
  }
}

}  // namespace

void name_field(SelectionVocabulary& vocabulary, const std::string& name,
                const std::string& field) {
  vocabulary.names[lower_case(name)] = field;
}

SelectionPtr parse_selection(const std::string& text, const SelectionVocabulary& vocabulary) {
  return SelectionParser(tokenize_selection(text), vocabulary).parse_expression();
}

std::vector<SelectionOrder> parse_selection_order(const std::string& text,
                                                  const SelectionVocabulary& vocabulary) {
  return SelectionParser(tokenize_selection(text), vocabulary).parse_order();
}

std::vector<std::string> used_fields(const SelectionPtr& selection) {
  std::set<std::string> fields;
  if (selection) collect(*selection, fields);
  return {fields.begin(), fields.end()};
}

std::vector<std::string> number_fields(const SelectionPtr& selection,
                                       const SelectionVocabulary& vocabulary) {
  std::vector<std::string> fields = used_fields(selection);
  fields.erase(
      std::remove_if(fields.begin(), fields.end(),
                     [&](const std::string& field) { return contains(vocabulary.texts, field); }),
      fields.end());
  return fields;
}

}  // namespace slalom
