#pragma once

#include <slalom/methods/slalom_method.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace reactive {

/// A parameter of a method: description, field and range, or the names of its values 0, 1, ...
template <typename Parameters>
struct Setting {
  slalom_parameter about;  ///< key, default, unit, help
  double Parameters::*field;
  double low = 0, high = HUGE_VAL;
  const char* const* names = nullptr;  ///< ends with a null pointer
};

/// Sets `value` to the index of `text` among `names`. Returns false and sets `error` if there is no
/// such name.
inline bool find_name(const char* const* names, const char* key, const char* text, double& value,
                      char* error, std::size_t error_size) {
  std::string expected;
  for (int i = 0; names[i] != nullptr; ++i) {
    value = i;
    if (std::strcmp(names[i], text) == 0) return true;
    expected += (i > 0 ? ", " : "") + std::string(names[i]);
  }
  std::snprintf(error, error_size, "%s = '%s' is invalid; expected one of %s", key, text,
                expected.c_str());
  return false;
}

/// Applies one setting. Returns false and sets `error` if the key is unknown or the value is not a
/// number within the range or one of the names.
template <typename Parameters, std::size_t N>
bool apply(const Setting<Parameters> (&known)[N], const char* key, const char* text,
           Parameters& parameters, char* error, std::size_t error_size) {
  for (const auto& setting : known) {
    if (std::strcmp(setting.about.key, key) != 0) continue;
    if (setting.names != nullptr)
      return find_name(setting.names, key, text, parameters.*setting.field, error, error_size);
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
