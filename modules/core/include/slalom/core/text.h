#pragma once

#include <string>
#include <vector>

namespace slalom {

std::string trim(const std::string& text);
std::vector<std::string> split(const std::string& text, char separator);  ///< parts trimmed
std::string join(const std::vector<std::string>& parts, const std::string& separator);

/// The shortest decimal text that reads back as the same double; "." whatever the locale.
std::string format_number(double number);

/// `number` with `digits` after the point.
std::string format_fixed(double number, int digits);

/// The whole text as a number, or false.
bool parse_number(const std::string& text, double& number);
bool parse_integer(const std::string& text, long long& number);

}  // namespace slalom
