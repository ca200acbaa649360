// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "manifest_text.h"
#include "rawlog_format.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <array>
#include <charconv>
#include <initializer_list>
#include <string>

namespace slalom {

/// Reads the values of one comment; errors name the file and the key.
class ManifestReader {
 public:
  ManifestReader(Manifest lines, std::string path)
      : lines_(std::move(lines)), path_(std::move(path)) {}

  bool has(const std::string& key) const { return lines_.count(key) > 0; }

  const std::string& text(const std::string& key) const {
    const auto found = lines_.find(key);
    if (found == lines_.end())
      throw file_error(path_, "missing key '" + key + "' in the manifest",
                       "a run recorded by Slalom");
    return found->second;
  }

  template <std::size_t N>
  std::array<double, N> numbers(const std::string& key) const {
    std::array<double, N> numbers{};
    if (!parse_numbers(text(key), N, numbers.data())) throw invalid(key, count_text(N, "number"));
    return numbers;
  }
  double number(const std::string& key) const { return numbers<1>(key)[0]; }

  template <typename Integer>
  Integer integer(const std::string& key) const {
    const std::string& t = text(key);
    Integer value = 0;
    const auto end = std::from_chars(t.data(), t.data() + t.size(), value);
    if (end.ec != std::errc() || end.ptr != t.data() + t.size() || value < 0)
      throw invalid(key, "a non-negative integer");
    return value;
  }

  Error invalid(const std::string& key, const std::string& expected) const {
    return file_error(path_, "invalid value of '" + key + "' in the manifest", expected);
  }

  /// All entries except those of the given keys.
  Manifest without(std::initializer_list<const char*> known) const {
    Manifest rest = lines_;
    for (const char* key : known) rest.erase(key);
    return rest;
  }

 private:
  Manifest lines_;
  std::string path_;
};

}  // namespace slalom
