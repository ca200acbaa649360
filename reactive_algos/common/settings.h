#pragma once

#include <slalom/methods/slalom_method.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace reactive {

/// A parameter of a method: description, field and range.
template <typename Parameters>
struct Setting {
  slalom_parameter about;  ///< key, default, unit, help
  double Parameters::*field;
  double low = 0, high = HUGE_VAL;
};

/// Applies one setting. Returns false and sets `error` if the key is unknown or the value is not a
/// number within the range.
template <typename Parameters, std::size_t N>
bool apply(const Setting<Parameters> (&known)[N], const char* key, const char* text,
           Parameters& parameters, char* error, std::size_t error_size) {
  for (const auto& setting : known) {
    if (std::strcmp(setting.about.key, key) != 0) continue;
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    const bool is_number = end != text && *end == '\0' && std::isfinite(value);
    if (is_number && value >= setting.low && value <= setting.high) {
      parameters.*setting.field = value;
      return true;
    }
    if (std::isinf(setting.high))
      std::snprintf(error, error_size, "%s = '%s' is invalid; expected a number >= %g", key, text,
                    setting.low);
    else
      std::snprintf(error, error_size, "%s = '%s' is invalid; expected a number in [%g, %g]", key,
                    text, setting.low, setting.high);
    return false;
  }
  std::snprintf(error, error_size, "unknown parameter %s", key);
  return false;
}

}  // namespace reactive
