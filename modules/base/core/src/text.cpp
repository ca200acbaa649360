// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row.back();
}

}  // namespace

std::string trim(const std::string& text) {
  const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  if (trim(text).empty()) return parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(trim(text.substr(begin, end - begin)));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

std::vector<std::string> split_nonempty(const std::string& text, char separator) {
  std::vector<std::string> parts = split(text, separator);
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return parts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::string join(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) {
    if (&part != &parts.front()) text += separator;
    text += part;
  }
  return text;
}

std::string count_text(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string unused_name(const std::string& name, std::set<std::string>& used) {
  for (int number = 1;; ++number) {
    const std::string other = number == 1 ? name : name + "_" + std::to_string(number);
    if (used.insert(other).second) return other;
  }
}

std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 2) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    const bool have_common = distance < std::max(word.size(), candidate.size());
    if (have_common && distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string expected_name(const std::string& name, const std::vector<std::string>& known,
                          const std::string& otherwise) {
  const std::string nearest = nearest_name(name, known);
  if (!nearest.empty()) return "'" + nearest + "'";
  return otherwise.empty() ? "one of " + join(known, ", ") : otherwise;
}

std::string format_number(double number) {
  return fmt::format("{}", number == 0 ? 0.0 : number);
}

std::string format_fixed(double number, int digits) {
  return fmt::format("{:.{}f}", number, digits);
}

bool parse_number(const std::string& text, double& number) {
  const std::string t = trim(text);
  const char* begin = t.data();
  const char* end = begin + t.size();
  if (begin != end && *begin == '+') ++begin;
  const auto result = std::from_chars(begin, end, number);
  return begin != end && result.ec == std::errc() && result.ptr == end && std::isfinite(number);
}

bool parse_integer(const std::string& text, long long& number) {
  const std::string t = trim(text);
  const char* begin = t.data();
  const char* end = begin + t.size();
  if (begin != end && *begin == '+') ++begin;
  const auto result = std::from_chars(begin, end, number);
  return begin != end && result.ec == std::errc() && result.ptr == end;
}

}  // namespace slalom
