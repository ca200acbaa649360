// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// A pattern of what the names of files say about runs: "{method}_{scenario}_{repetition}.csv".
class NamePattern {
 public:
  /// Throws Error (Usage) for a malformed one.
  explicit NamePattern(const std::string& text);

  bool has(const std::string& field) const;

  using Fields = std::map<std::string, std::string>;
  /// All ways in which the end of a path can be read: as many folders as the pattern has, and
  /// without the extension if it has none. A repetition is a number.
  std::vector<Fields> matches(const std::string& path) const;

 private:
  struct Part {
    bool is_field;
    std::string text;
  };
  std::vector<Part> parts_;
  std::size_t folders_ = 0;
  bool has_extension_ = false;

  void match(std::size_t part, const std::string& rest, Fields& fields,
             std::vector<Fields>& found) const;
};

}  // namespace slalom
