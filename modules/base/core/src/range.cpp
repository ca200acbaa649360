// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/range.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

constexpr const char* kTo = "..";

}  // namespace

bool Range::contains(double value) const {
  return (low_open ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
  if (is_bounded())
    return std::string("in ") + (low_open ? "(" : "[") + format_number(low) + ", " +
           format_number(high) + "]";
  if (bounded_below()) return (low_open ? "> " : ">= ") + format_number(low);
  if (bounded_above()) return "<= " + format_number(high);
  return "any";
}

std::string range_notation(const Range& range) {
  return (range.bounded_below() ? format_number(range.low) : "") + kTo +
         (range.bounded_above() ? format_number(range.high) : "");
}

std::optional<Range> parse_range(const std::string& notation) {
  const std::size_t to = notation.find(kTo);
  if (to == std::string::npos) return std::nullopt;
  const std::string low = notation.substr(0, to), high = notation.substr(to + 2);
  Range range;
  if (!low.empty() && !parse_number(low, range.low)) return std::nullopt;
  if (!high.empty() && !parse_number(high, range.high)) return std::nullopt;
  if (!(range.low <= range.high)) return std::nullopt;
  return range;
}

}  // namespace slalom
