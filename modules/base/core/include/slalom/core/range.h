// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>

namespace slalom {

/// The valid values of an option, or the possible ones of a quantity. An infinite end is none.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not allowed

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }
  static Range at_least(double low) {
    return {low, std::numeric_limits<double>::infinity(), false};
  }
  static Range at_most(double high) {
    return {-std::numeric_limits<double>::infinity(), high, false};
  }
  static Range between(double low, double high) { return {low, high, false}; }
  bool bounded_below() const { return low > -std::numeric_limits<double>::infinity(); }
  bool bounded_above() const { return high < std::numeric_limits<double>::infinity(); }
  bool is_bounded() const { return bounded_below() && bounded_above(); }
  bool contains(double value) const;
  std::string text() const;  ///< e.g. "> 0", "in [0, 1]"
};

/// "0..1", "0..", "..1" or "..", as files and the command line write a range with closed ends.
std::string range_notation(const Range& range);
std::optional<Range> parse_range(const std::string& notation);  ///< nullopt unless low <= high

}  // namespace slalom
