#pragma once

#include <slalom/io/list_selection.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// A selection as SQL. Whatever the user wrote stands in `bindings`, never in the text.
struct SelectionSql {
  std::string text;  ///< "SELECT s.hash FROM scenarios s ... LIMIT ?"
  std::vector<std::variant<double, std::string, std::int64_t>> bindings;

  void bind(SQLite::Statement& statement, int first = 1) const;
};

/// What the translation asks the list.
struct SelectionSources {
  /// The condition on a column of keys that stands for these keys, such as "IN (7,8)": the same
  /// text that the index of these keys was made with, or SQLite would not use it.
  std::function<std::string(const std::vector<DescriptorKey>&)> key_condition;
  std::function<ListIndex(const std::string& name)> index;
};

SelectionSql translate_selection(const ListSelection& selection, const SelectionSources& sources);

}  // namespace slalom
