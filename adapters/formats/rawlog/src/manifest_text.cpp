// SPDX-License-Identifier: BSD-3-Clause
#include "manifest_text.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <optional>

namespace slalom {
namespace {

constexpr const char* kIndent = "  ";

/// Splits at line breaks; at least one line.
std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  lines.push_back(text.substr(begin));
  return lines;
}

bool fits_one_line(const std::string& value) {
  return value.find('\n') == std::string::npos && value == trim(value);
}

}  // namespace

std::string manifest_to_text(const Manifest& manifest) {
  std::string text;
  for (const auto& [key, value] : manifest) {
    text += key + " =";
    if (fits_one_line(value)) {
      text += value.empty() ? "\n" : " " + value + "\n";
      continue;
    }
    text += "\n";
    for (const std::string& line : split_lines(value)) text += kIndent + line + "\n";
  }
  return text;
}

Manifest manifest_from_text(const std::string& text, const std::string& where) {
  Manifest manifest;
  std::string* block = nullptr;  // the value that indented lines continue
  bool first_of_block = false;
  std::vector<std::string> lines = split_lines(text);
  if (lines.back().empty()) lines.pop_back();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.compare(0, 2, kIndent) == 0 && block != nullptr) {
      *block += (first_of_block ? "" : "\n") + line.substr(2);
      first_of_block = false;
      continue;
    }
    const std::size_t equals = line.find(" =");
    if (equals == std::string::npos || equals == 0)
      throw file_error(where, "line " + std::to_string(i + 1) + " of a comment is malformed",
                       "key = value");
    const auto [entry, is_new] =
        manifest.emplace(line.substr(0, equals), trim(line.substr(equals + 2)));
    if (!is_new) throw file_error(where, "duplicate key '" + entry->first + "'", "each key once");
    block = entry->second.empty() ? &entry->second : nullptr;
    first_of_block = true;
  }
  return manifest;
}

}  // namespace slalom
