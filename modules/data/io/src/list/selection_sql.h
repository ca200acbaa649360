// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/list_selection.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// A selection as SQL. User input is only in `bindings`, never in the text.
struct SelectionSql {
  std::string text;  ///< "SELECT s.hash FROM scenarios s ... LIMIT ?"
  std::vector<std::variant<double, std::string, std::int64_t>> bindings;

  void bind(SQLite::Statement& statement, int first = 1) const;
};

/// Data of the list that the translation needs.
struct SelectionSources {
  /// The SQL condition for these keys, such as "IN (7,8)". It must be textually identical to that
  /// of the index of these keys, or SQLite does not use the index.
  std::function<std::string(const std::vector<ValueKey>&)> key_condition;
  std::function<ListIndex(const std::string& name)> index;
  /// The table (hash, value) of a field that is not in the list; "" if there is none.
  std::function<std::string(const std::string& field)> table;
};

SelectionSql translate_selection(const ListSelection& selection, const SelectionSources& sources);

}  // namespace slalom
