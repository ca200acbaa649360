// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/visited_options.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace slalom {
namespace {

std::string long_name(std::string key) {
  std::replace(key.begin(), key.end(), '_', '-');
  return "--" + key;
}

bool has_range(const Option& option) {
  return (option.get_if<int>() != nullptr || option.get_if<double>() != nullptr) &&
         option.range.text() != Range::any().text();
}

/// "Cell size of grids, m (> 0)", of "cell size of grids".
std::string help_of(const Option& option) {
  std::string help = option.help;
  if (!help.empty()) help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  if (!option.unit.empty() && option.unit != "-") help += ", " + option.unit;
  return has_range(option) ? help + " (" + option.expected() + ")" : help;
}

std::string type_of(const Option& option) {
  if (option.get_if<std::string>() != nullptr) return "TEXT";
  const bool is_integer =
      option.get_if<int>() != nullptr || option.get_if<std::uint64_t>() != nullptr;
  return is_integer ? "INT" : "FLOAT";
}

}  // namespace

void add_visited_options(CLI::App& app, const std::function<void(OptionVisitor&)>& visit) {
  OptionFunction add([&](const Option& declared) {
    const std::string name = long_name(declared.key);
    const auto set = [visit, name, key = declared.key](const std::string& text) {
      OptionFunction set_one([&](const Option& option) {
        if (option.key == key) option.set(text, name);
      });
      visit(set_one);
    };
    if (declared.get_if<bool>() != nullptr) {
      app.add_flag_callback(
          name, [set] { set("true"); }, help_of(declared));
      return;
    }
    CLI::Option* option = app.add_option_function<std::string>(name, set, help_of(declared));
    option->type_name(type_of(declared));
    const double* number = declared.get_if<double>();
    if (number == nullptr || std::isfinite(*number)) option->default_str(declared.text());
    if (!declared.choices.empty()) option->check(CLI::IsMember(declared.choices));
  });
  visit(add);
}

}  // namespace slalom
