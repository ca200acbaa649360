// SPDX-License-Identifier: BSD-3-Clause
#include "selection_sql.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

using Node = SelectionNode;

std::string text_column(const std::string& field) {
  if (field == "id") return "s.hash";
  if (field == "name" || field == "generator" || field == "representation") return "s." + field;
  throw usage_error("selection", "invalid field '" + field + "'",
                    "name, id, generator or representation");
}

/// Translates an expression. Selections have the three-valued logic of SQL: a comparison with NULL
/// is neither true nor false.
class Translator {
 public:
  Translator(const ListSelection& selection, const SelectionSources& sources)
      : selection_(selection), sources_(sources) {}

  SelectionSql translate() {
    std::string where;
    if (selection_.where) where += " WHERE (" + visit(*selection_.where) + ")";
    if (selection_.hashes) where += (where.empty() ? " WHERE " : " AND ") + among_hashes();
    const std::string order = order_by();
    sql_.text = "SELECT s.hash FROM scenarios s" + joins_ + where + " ORDER BY " + order;
    if (selection_.limit) {
      sql_.text += " LIMIT ?";
      sql_.bindings.emplace_back(static_cast<std::int64_t>(*selection_.limit));
    }
    return sql_;
  }

 private:
  std::string visit(const Node& node) {
    return std::visit([this](const auto& what) { return write(what); }, node.what);
  }

  std::string write(const Node::Compare& c) {
    const std::string left = operand(c.left);
    return left + " " + to_string(c.op) + " " + operand(c.right);
  }

  std::string write(const Node::Within& w) {
    const std::string value = column(selection_.view, w.field);
    return within(value, w.low, w.low_open, w.high, w.high_open);
  }

  /// With redundant range limits, so that SQLite can use an index.
  std::string write(const Node::NumberInSet& among) {
    const std::string value = column(selection_.view, among.field);
    const auto [min, max] = std::minmax_element(among.values.begin(), among.values.end());
    const std::string limits = within(value, *min, false, *max, false);
    std::string list;
    for (const double number : among.values) list += (list.empty() ? "" : ", ") + bound(number);
    return "(" + limits + " AND " + value + " IN (" + list + "))";
  }

  std::string write(const Node::TextInSet& among) {
    std::string list;
    if (among.field == "id") {
      for (const std::string& id : among.values)
        list += (list.empty() ? "" : " OR ") + begins_with("s.hash", id);
      return "(" + list + ")";
    }
    for (const std::string& text : among.values) list += (list.empty() ? "" : ", ") + bound(text);
    if (is_text(among.field)) return any_text(among.field, "value IN (" + list + ")");
    if (among.field == "tag") return tagged("tag IN (" + list + ")");
    return text_column(among.field) + " IN (" + list + ")";
  }

  std::string write(const Node::Matches& m) {
    const std::string like = (m.glob ? " GLOB " : " LIKE ") + bound(m.pattern);
    if (is_text(m.field)) return any_text(m.field, "value" + like);
    return m.field == "tag" ? tagged("tag" + like) : text_column(m.field) + like;
  }

  std::string write(const Node::IsNa& na) {
    if (na.field == "tag") return "s.hash NOT IN (SELECT hash FROM tags)";
    if (is_text(na.field)) return any_text(na.field, "1") + " IS NULL";
    if (is_number(na.field)) return column(selection_.view, na.field) + " IS NULL";
    return text_column(na.field) + " IS NULL";
  }

  std::string write(const Node::InRange& in) {
    const ListIndex index = sources_.index(in.index);
    const std::string value = column_of(index.keys);
    const bool last = in.range + 1 == index.ranges();
    return within(value, index.edges.at(in.range), false, index.edges.at(in.range + 1), !last);
  }

  std::string write(const Node::Compound& joined) {
    if (joined.op == Node::Connective::Not) return "NOT (" + visit(*joined.parts.front()) + ")";
    std::string text;
    for (const SelectionPtr& part : joined.parts) {
      if (!text.empty()) text += joined.op == Node::Connective::And ? " AND " : " OR ";
      text += "(" + visit(*part) + ")";
    }
    return text;
  }

  std::string within(const std::string& value, double low, bool low_open, double high,
                     bool high_open) {
    const std::string above = value + (low_open ? " > " : " >= ") + bound(low);
    return "(" + above + " AND " + value + (high_open ? " < " : " <= ") + bound(high) + ")";
  }

  std::string begins_with(const std::string& column, const std::string& start) {
    const std::string text = lower_case(start);
    const std::string from = column + " >= " + bound(text);
    return "(" + from + " AND " + column + " < " + bound(text + "g") + ")";  // 'g' follows 'f'
  }

  static std::string tagged(const std::string& condition) {
    return "s.hash IN (SELECT hash FROM tags WHERE " + condition + ")";
  }

  std::string among_hashes() {
    std::string json;
    for (const std::string& hash : *selection_.hashes) {
      if (!std::all_of(hash.begin(), hash.end(), [](unsigned char c) { return std::isxdigit(c); }))
        throw usage_error("selection", "invalid hash '" + hash + "'");
      json += (json.empty() ? "\"" : ",\"") + hash + "\"";
    }
    return "s.hash IN (SELECT value FROM json_each(" + bound("[" + json + "]") + "))";
  }

  std::string order_by() {
    std::string text;
    for (const SelectionOrder& order : selection_.order) {
      const std::string value = is_number(order.field) ? column(selection_.view, order.field)
                                : is_text(order.field) ? any_text(order.field, "value")
                                                       : text_column(order.field);
      text += value + " IS NULL, " + value + (order.descending ? " DESC, " : ", ");
    }
    return text + "s.position";
  }

  std::string operand(const SelectionOperand& operand) {
    if (const double* number = std::get_if<double>(&operand)) return bound(*number);
    return column(selection_.view, std::get<std::string>(operand));
  }

  /// Whether it is a text that is not in the list.
  bool is_text(const std::string& field) const {
    const auto found = selection_.fields.find(field);
    return found != selection_.fields.end() && found->second->is_text;
  }
  bool is_number(const std::string& field) const {
    return selection_.view.count(field) > 0 ||
           (selection_.fields.count(field) > 0 && !is_text(field));
  }

  /// The largest result over the texts of a scenario: NULL if it has none.
  std::string any_text(const std::string& field, const std::string& expression) const {
    return "(SELECT MAX(" + expression + ") FROM " + sources_.table(field) +
           " WHERE hash = s.hash)";
  }

  std::string column(const DescriptorView& view, const std::string& field) {
    if (selection_.fields.count(field) > 0)
      return "(SELECT value FROM " + sources_.table(field) + " WHERE hash = s.hash)";
    const auto keys = view.find(field);
    if (keys == view.end())
      throw usage_error("selection", "unknown field '" + field + "'", "a descriptor");
    return column_of(keys->second);
  }

  /// The column with the values of these keys; each set of keys is joined only once.
  std::string column_of(const std::vector<ValueKey>& keys) {
    const std::string condition = sources_.key_condition(keys);
    const auto found = std::find(joined_.begin(), joined_.end(), condition);
    const std::string alias = "d" + std::to_string(found - joined_.begin());
    if (found == joined_.end()) {
      joined_.push_back(condition);
      joins_ += " LEFT JOIN descriptor_values " + alias + " ON " + alias + ".hash = s.hash AND " +
                alias + ".key " + condition;
    }
    return alias + ".value";
  }

  template <typename T>
  std::string bound(const T& value) {
    sql_.bindings.emplace_back(value);
    return "?";
  }

  const ListSelection& selection_;
  const SelectionSources& sources_;
  SelectionSql sql_;
  std::string joins_;
  std::vector<std::string> joined_;
};

}  // namespace

SelectionSql translate_selection(const ListSelection& selection, const SelectionSources& sources) {
  return Translator(selection, sources).translate();
}

void SelectionSql::bind(SQLite::Statement& statement, int first) const {
  for (const auto& binding : bindings) {
    std::visit([&](const auto& value) { statement.bind(first, value); }, binding);
    ++first;
  }
}

}  // namespace slalom
