#include <slalom/core/text.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace slalom {

std::string trim(const std::string& text) {
  const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
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

std::string join(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) {
    if (&part != &parts.front()) text += separator;
    text += part;
  }
  return text;
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
