// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/option.h>

#include <string>

namespace reactive {

/// The map on which a path is planned.
enum class PathMap { Sensed, Known };
constexpr auto enum_names(PathMap) {
  return std::array{"sensed", "known"};
}

/// Sets a parameter. Throws slalom::Error for an unknown key and an invalid value.
template <typename Parameters>
void set_parameter(Parameters& parameters, const std::string& key, const std::string& text) {
  bool known = false;
  slalom::for_each_option(parameters, [&](const slalom::Option& option) {
    if (option.key != key) return;
    known = true;
    option.set(text, key);
  });
  if (!known) throw slalom::usage_error(key, "unknown parameter");
}

}  // namespace reactive
