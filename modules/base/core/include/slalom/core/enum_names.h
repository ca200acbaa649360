// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Enums with names, as in options, files and messages. Such an enum has the values 0, 1, 2, ...
/// and declares their names beside it, in the same order:
///
///     enum class Kinematics { DiffDrive, Holonomic };
///     constexpr auto enum_names(Kinematics) { return std::array{"diff_drive", "holonomic"}; }
///
/// The functions below and OptionVisitor follow from that one table.
template <typename Enum>
using EnumNames = decltype(enum_names(std::declval<Enum>()));

template <typename Enum, typename = EnumNames<Enum>>
std::string to_string(Enum value) {
  return enum_names(value).at(static_cast<std::size_t>(value));
}

/// In the order of the values.
template <typename Enum>
std::vector<std::string> names_of() {
  const auto names = enum_names(Enum());
  return {names.begin(), names.end()};
}

template <typename Enum>
std::vector<Enum> enum_values() {
  std::vector<Enum> values(enum_names(Enum()).size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
  return values;
}

/// The value with this name; none if there is no such name.
template <typename Enum>
std::optional<Enum> from_name(const std::string& name) {
  for (const Enum value : enum_values<Enum>())
    if (to_string(value) == name) return value;
  return std::nullopt;
}

/// The same for a name in a file. `kind` is what it is the name of, e.g. "outcome". Throws Error
/// (File) if there is no such name.
template <typename Enum>
Enum from_stored_name(const std::string& kind, const std::string& name) {
  if (const auto value = from_name<Enum>(name)) return *value;
  throw file_error(kind, "unknown " + kind + " '" + name + "'",
                   "one of " + join(names_of<Enum>(), ", "));
}

}  // namespace slalom
