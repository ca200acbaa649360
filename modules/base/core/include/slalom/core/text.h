// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace slalom {

std::string trim(const std::string& text);
std::string lower_case(std::string text);  ///< changes ASCII letters only
std::vector<std::string> split(const std::string& text, char separator);  ///< parts trimmed
std::vector<std::string> split_nonempty(const std::string& text, char separator);
std::string join(const std::vector<std::string>& parts, const std::string& separator);
bool contains(const std::vector<std::string>& texts, const std::string& text);
bool starts_with(std::string_view text, std::string_view start);
bool ends_with(std::string_view text, std::string_view end);

/// "1 run", "2 runs".
std::string count_text(std::size_t n, const std::string& noun);

/// The name, with a number if it is in use, "name_2"; it then is.
std::string unused_name(const std::string& name, std::set<std::string>& used);

/// The candidate with the smallest edit distance to `word`, or "" if none is close.
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// The expected names, for messages about an unknown one: the nearest known one in quotes;
/// `otherwise` if none is close, or if that is empty, "one of" all.
std::string expected_name(const std::string& name, const std::vector<std::string>& known,
                          const std::string& otherwise = "");

/// The shortest decimal text that reads back as the same double, independent of the locale.
std::string format_number(double number);

/// `number` with `digits` after the point.
std::string format_fixed(double number, int digits);

/// Parses the complete text as a finite number; returns false on failure.
bool parse_number(const std::string& text, double& number);
bool parse_integer(const std::string& text, long long& number);

}  // namespace slalom
