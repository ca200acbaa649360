// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/option.h>
#include <slalom/core/text.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

constexpr char kSeedRange[] = "in [0, 9223372036854775807]";
constexpr std::uint64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();

bool set_value(double& value, const std::string& text) {
  return parse_number(text, value);
}
bool set_value(std::optional<double>& value, const std::string& text) {
  return parse_number(text, value.emplace());
}
bool set_value(int& value, const std::string& text) {
  long long number = 0;
  if (!parse_integer(text, number) || number > std::numeric_limits<int>::max() ||
      number < std::numeric_limits<int>::min())
    return false;
  value = static_cast<int>(number);
  return true;
}
bool set_value(std::uint64_t& value, const std::string& text) {
  long long number = 0;
  if (!parse_integer(text, number) || number < 0) return false;
  value = static_cast<std::uint64_t>(number);
  return true;
}
bool set_value(bool& value, const std::string& text) {
  value = text == "true" || text == "yes" || text == "on" || text == "1";
  return value || text == "false" || text == "no" || text == "off" || text == "0";
}
bool set_value(std::string& value, const std::string& text) {
  value = text;
  return true;
}

std::string text_of(double value) {
  return format_number(value);
}
std::string text_of(const std::optional<double>& value) {
  return text_of(value.value());
}
std::string text_of(int value) {
  return std::to_string(value);
}
std::string text_of(std::uint64_t value) {
  return std::to_string(value);
}
std::string text_of(bool value) {
  return value ? "true" : "false";
}
std::string text_of(const std::string& value) {
  return value;
}

bool is_valid(const Option& option, double value) {
  return std::isfinite(value) && option.range.contains(value);
}
bool is_valid(const Option& option, const std::optional<double>& value) {
  return !value || is_valid(option, *value);
}
bool is_valid(const Option& option, int value) {
  return option.range.contains(value);
}
bool is_valid(const Option&, std::uint64_t value) {
  return value <= kMaxSeed;
}
bool is_valid(const Option&, bool) {
  return true;
}
bool is_valid(const Option& option, const std::string& value) {
  return option.choices.empty() || contains(option.choices, value);
}

Error invalid_value(const Option& option, const std::string& text, const std::string& where) {
  std::string kind;
  if (option.get_if<double>() != nullptr || option.get_if<std::optional<double>>() != nullptr)
    kind = "a number ";
  if (option.get_if<int>() != nullptr || option.get_if<std::uint64_t>() != nullptr)
    kind = "an integer ";
  std::string expected =
      option.choices.empty() ? kind + option.expected() : "one of " + join(option.choices, ", ");
  if (!option.unit.empty() && option.unit != "-") expected += ", in " + option.unit;
  return usage_error(where, "'" + text + "' is not valid", expected);
}

}  // namespace

std::string Option::text() const {
  if (const auto* number = get_if<std::optional<double>>(); number != nullptr && !*number)
    return absent;
  return std::visit([](const auto* of) { return text_of(*of); }, value);
}

std::string Option::expected() const {
  if (get_if<std::uint64_t>() != nullptr) return kSeedRange;
  if (get_if<bool>() != nullptr) return "true or false";
  if (get_if<std::optional<double>>() != nullptr) return range.text() + ", or " + absent;
  if (get_if<std::string>() == nullptr) return range.text();
  return choices.empty() ? "text" : join(choices, " | ");
}

void Option::set(const std::string& text, const std::string& where) const {
  if (auto* number = get_if<std::optional<double>>(); number != nullptr && text == absent) {
    number->reset();
    return;
  }
  std::visit(
      [&](auto* to) {
        auto read = *to;
        if (!set_value(read, text) || !is_valid(*this, read))
          throw invalid_value(*this, text, where);
        *to = read;
      },
      value);
}

void Option::check(const std::string& where) const {
  const bool valid = std::visit([&](const auto* of) { return is_valid(*this, *of); }, value);
  if (!valid) throw invalid_value(*this, text(), where);
}

}  // namespace slalom
