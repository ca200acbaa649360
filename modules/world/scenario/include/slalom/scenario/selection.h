// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// The names that a selection expression may use.
struct SelectionVocabulary {
  std::vector<std::string> numbers;            ///< numeric fields, such as descriptors
  std::vector<std::string> texts;              ///< text fields, such as name
  std::map<std::string, std::size_t> indexes;  ///< number of ranges of each index, by name
  /// Other names of fields, such as "mean clearance", to the fields: see name_field().
  std::map<std::string, std::string> names = {};
};

/// Lets expressions call a field by another name, ignoring case.
void name_field(SelectionVocabulary& vocabulary, const std::string& name, const std::string& field);

/// An operand of a comparison: a number, or the name of a numeric field.
using SelectionOperand = std::variant<double, std::string>;

enum class Comparison { Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual };
/// Operators of SQL.
constexpr auto enum_names(Comparison) {
  return std::array{"<", "<=", ">", ">=", "=", "<>"};
}

/// A selection expression as a tree. A comparison with NA is neither true nor false: it selects
/// nothing, negated or not.
struct SelectionNode {
  /// left OP right, of numbers
  struct Compare {
    SelectionOperand left;
    Comparison op;
    SelectionOperand right;
  };
  /// field within an interval of numbers
  struct Within {
    std::string field;
    double low, high;
    bool low_open, high_open;
  };
  /// number in a set
  struct NumberInSet {
    std::string field;
    std::vector<double> values;
  };
  /// text in a set; ids are compared as prefixes
  struct TextInSet {
    std::string field;
    std::vector<std::string> values;
  };
  /// text matches a pattern: of SQL (% and _, ignoring case) or of a shell (*, ?, [..])
  struct Matches {
    std::string field, pattern;
    bool glob;
  };
  struct IsNa {
    std::string field;
  };
  /// range number `range` of an index, from 0
  struct InRange {
    std::string index;
    std::size_t range;
  };
  enum class Connective { And, Or, Not };
  struct Compound {
    Connective op;
    std::vector<std::shared_ptr<const SelectionNode>> parts;  ///< one for Not
  };
  std::variant<Compare, Within, NumberInSet, TextInSet, Matches, IsNa, InRange, Compound> what;
};

using SelectionPtr = std::shared_ptr<const SelectionNode>;

/// Parses an expression:
///
///     density >= 0.1 and density < 0.2 and not (confinement > 0.8)
///     0.1 <= density < 0.2          density between 0.1 and 0.2      density in [0.1, 0.2)
///     density in (0.1, 0.2, 0.3)    bottleneck_width is not na       density < clearness
///     name like 'office%'           name glob maze_00[1-3]?          tag = narrow
///     generator in (maze, forest)   id = 73f8d0                      by_density[1]
///
/// `between` includes both ends; parentheses after `in` enclose a list; a bracket on either side
/// makes it an interval. Texts are in single or double quotes (doubled within), or unquoted if they
/// are one word. Fields may be called by their names: mean clearance > 0.5, with quotes where a
/// name has other characters than words: "Clearance, 5 % quantile" > 0.3. Keywords are
/// case-insensitive. Throws Error (Usage) with the character position, what was expected and the
/// nearest name.
SelectionPtr parse_selection(const std::string& text, const SelectionVocabulary& vocabulary);

struct SelectionOrder {
  std::string field;
  bool descending = false;
};

/// Parses "density desc, name". Throws Error (Usage) like parse_selection().
std::vector<SelectionOrder> parse_selection_order(const std::string& text,
                                                  const SelectionVocabulary& vocabulary);

/// All fields used in an expression, sorted, without duplicates and without indexes.
std::vector<std::string> used_fields(const SelectionPtr& selection);

/// Names of the numeric fields used in an expression, sorted, without duplicates and without
/// indexes.
std::vector<std::string> number_fields(const SelectionPtr& selection,
                                       const SelectionVocabulary& vocabulary);

}  // namespace slalom
