// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/range.h>

#include <optional>
#include <string>

namespace slalom {

/// A number, or an explicit "not available" with the reason; never replaced by a neutral value.
class Value {
 public:
  static Value of(double number);  ///< a number that is not finite becomes NA
  static Value of(double number, double standard_error);
  static Value na(std::string reason);

  bool is_na() const { return !number_.has_value(); }
  double number() const;                                 ///< requires !is_na()
  const std::string& reason() const { return reason_; }  ///< empty unless NA
  std::optional<double> standard_error() const { return standard_error_; }

  bool operator==(const Value& other) const;
  bool operator!=(const Value& other) const { return !(*this == other); }

 private:
  std::optional<double> number_;
  std::optional<double> standard_error_;
  std::string reason_;
};

/// "0.68", "2.5 m", "NA (outcome: stuck)"; without the standard error.
std::string format_value(const Value& value, const std::string& unit = "-");

enum class Direction { Up, Down, None };  ///< which direction is better
constexpr auto enum_names(Direction) {
  return std::array{"up", "down", "none"};
}

/// Kind of the values of a quantity: 0 or 1, whose mean is a rate; numbers of things; lengths,
/// times and the like; numbers without a unit; numbers from 0 that are 0 in runs that failed, and
/// only there.
enum class QuantityKind { Rate, Count, Amount, Ratio, Score };
constexpr auto enum_names(QuantityKind) {
  return std::array{"rate", "count", "amount", "ratio", "score"};
}

/// Describes a computed quantity (a scenario descriptor or a metric). The formula of an (id,
/// version) never changes.
struct QuantityInfo {
  std::string id;  ///< as in tables and files, e.g. "clearness"
  int version = 1;
  std::string name;  ///< for people, e.g. "Clearness"
  std::string unit;  ///< "-" where it has none
  Direction direction = Direction::None;
  QuantityKind kind = QuantityKind::Amount;
  Range range = {};  ///< of its values, by its definition; keeps intervals within the possible

  bool is_rate() const { return kind == QuantityKind::Rate; }
};

/// Identifies a stored value of a quantity.
struct ValueKey {
  std::string id;
  int version = 1;
  std::string parameters = {};  ///< on which the value depends, "key=value;...", "" for none
};

/// A value and what it is of.
struct KeyedValue {
  ValueKey key;
  Value value;
};

}  // namespace slalom
