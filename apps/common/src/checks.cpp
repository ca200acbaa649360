// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/checks.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <functional>
#include <string>

namespace slalom {
namespace {

CLI::Validator check(const std::string& help, const std::string& expected,
                     const std::function<bool(double)>& accepts) {
  return CLI::Validator(
      [expected, accepts](std::string& text) -> std::string {
        double value = 0;
        if (parse_number(text, value) && accepts(value)) return "";
        return "'" + printable_line(text) + "' is not valid; expected " + expected;
      },
      help);
}

}  // namespace

CLI::Validator above_zero() {
  return check("POSITIVE", "a number above 0", [](double value) { return value > 0; });
}

CLI::Validator not_negative() {
  return check("NONNEGATIVE", "a number of at least 0", [](double value) { return value >= 0; });
}

CLI::Validator in_range(double low, double high) {
  const std::string from = format_number(low), to = format_number(high);
  return check("in [" + from + " - " + to + "]", "a number in [" + from + ", " + to + "]",
               [low, high](double value) { return value >= low && value <= high; });
}

void check_numbers(CLI::App& app) {
  const auto is_number = [](const CLI::Option* option) {
    return option->get_type_name().find("FLOAT") != std::string::npos;
  };
  for (CLI::Option* option : app.get_options(is_number))
    option->check(check("", "a number", [](double) { return true; }));
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) check_numbers(*verb);
}

}  // namespace slalom
