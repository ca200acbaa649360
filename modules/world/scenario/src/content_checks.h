// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>

namespace slalom {

/// Limits (s, m, m/s) far beyond any use: no computation with a mover or a person overflows.
constexpr double kMaxNumber = 1e6, kMaxSpeed = 1000;

inline bool in_range(double number) {
  return std::abs(number) <= kMaxNumber;
}

inline bool in_range(const mrpt::math::TPoint2D& p) {
  return in_range(p.x) && in_range(p.y);
}

/// Adds the id of element `i` of a list, a `kind`, to those of the others. Returns the words that
/// name the element in messages. Throws Error (File) if the id is invalid or used twice.
inline std::string checked_element(const std::string& name, const std::string& kind, std::size_t i,
                                   const std::string& id, std::set<std::string>& ids) {
  constexpr std::size_t kMaxIdBytes = 100;
  const std::string start = name + ": " + kind + " ";
  if (id.empty() || id.size() > kMaxIdBytes || find_invalid_utf8(id))
    throw file_error(start + std::to_string(i), "invalid id", "1 to 100 bytes of UTF-8");
  const std::string where = start + "'" + id + "'";
  if (!ids.insert(id).second) throw file_error(where, "duplicate id", "unique ids");
  return where;
}

inline void check_radius(const std::string& where, double radius) {
  if (!in_range(radius) || !(radius > 0))
    throw file_error(where, "invalid radius " + format_number(radius) + " m",
                     "a radius above 0, at most " + format_number(kMaxNumber));
}

}  // namespace slalom
