#include "selection_parser.h"

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
  }
}

}  // namespace

SelectionPtr parse_selection(const std::string& text, const SelectionVocabulary& vocabulary) {
  return SelectionParser(tokenize_selection(text), vocabulary).parse_expression();
}

std::vector<SelectionOrder> parse_selection_order(const std::string& text,
                                                  const SelectionVocabulary& vocabulary) {
  return SelectionParser(tokenize_selection(text), vocabulary).parse_order();
}

std::vector<std::string> number_fields(const SelectionPtr& selection,
                                       const SelectionVocabulary& vocabulary) {
  std::set<std::string> fields;
  if (selection) collect(*selection, fields);
  for (const std::string& text : vocabulary.texts) fields.erase(text);
  return {fields.begin(), fields.end()};
}

}  // namespace slalom
