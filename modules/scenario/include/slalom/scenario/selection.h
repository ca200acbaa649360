#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

/// What a selection expression may speak of.
struct SelectionVocabulary {
  std::vector<std::string> numbers;            ///< fields with a number, such as descriptors
  std::vector<std::string> texts;              ///< fields with a text, such as name
  std::map<std::string, std::size_t> indexes;  ///< names of indexes, with how many ranges each has
};

/// A value to compare: a number, or the name of a field that has one.
using SelectionOperand = std::variant<double, std::string>;

enum class Comparison { Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual };

/// A selection expression as a tree. A comparison with a value that is NA is neither true nor
/// false: it chooses nothing, whether a "not" stands before it or not.
struct SelectionNode {
  /// left OP right, of numbers
  struct Compare {
    SelectionOperand left;
    Comparison how;
    SelectionOperand right;
  };
  /// field within an interval of numbers
  struct Within {
    std::string field;
    double low, high;
    bool low_open, high_open;
  };
  /// number among these
  struct AmongNumbers {
    std::string field;
    std::vector<double> values;
  };
  /// text among these; an id by how it begins
  struct AmongTexts {
    std::string field;
    std::vector<std::string> values;
  };
  /// text like a pattern: SQL's (% and _, whatever the case) or a shell's (*, ?, [..])
  struct Matches {
    std::string field, pattern;
    bool glob;
  };
  struct IsNa {
    std::string field;
  };
  /// the `range`th range of an index, counted from 0
  struct InRange {
    std::string index;
    std::size_t range;
  };
  enum class Connective { And, Or, Not };
  struct Joined {
    Connective how;
    std::vector<std::shared_ptr<const SelectionNode>> parts;  ///< one for Not
  };
  std::variant<Compare, Within, AmongNumbers, AmongTexts, Matches, IsNa, InRange, Joined> what;
};

using SelectionPtr = std::shared_ptr<const SelectionNode>;

/// Reads an expression:
///
///     density >= 0.1 and density < 0.2 and not (confinement > 0.8)
///     0.1 <= density < 0.2          density between 0.1 and 0.2      density in [0.1, 0.2)
///     density in (0.1, 0.2, 0.3)    bottleneck_width is not na       density < clearness
///     name like 'office%'           name glob maze_00[1-3]?          tag = narrow
///     generator in (maze, forest)   id = 73f8d0                      by_density[1]
///
/// `between` includes both ends; parentheses after `in` hold a list, and a bracket on either side
/// makes it an interval. Texts stand in single or double quotes (doubled within), or bare where
/// they are one word. Key words in any case. Throws Error (Usage) that says at which character,
/// what was expected and the nearest name.
SelectionPtr parse_selection(const std::string& text, const SelectionVocabulary& vocabulary);

struct SelectionOrder {
  std::string field;
  bool descending = false;
};

/// Reads "density desc, name". Throws Error (Usage) like parse_selection().
std::vector<SelectionOrder> parse_selection_order(const std::string& text,
                                                  const SelectionVocabulary& vocabulary);

/// Names of the fields with numbers that an expression speaks of, sorted, each once. Indexes are
/// not among them.
std::vector<std::string> number_fields(const SelectionPtr& selection,
                                       const SelectionVocabulary& vocabulary);

}  // namespace slalom
