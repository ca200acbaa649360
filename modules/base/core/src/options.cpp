// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/options.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

void OptionReader::visit(const Option& option) {
  known_.push_back(option.key);
  if (const auto text = ini_.get(section_, option.key))
    option.set(*text, ini_.where(section_, option.key));
}

std::vector<std::pair<std::string, std::string>> OptionReader::unvisited() const {
  std::vector<std::pair<std::string, std::string>> options;
  for (const std::string& key : ini_.keys(section_))
    if (!contains(known_, key)) options.emplace_back(key, *ini_.get(section_, key));
  return options;
}

void OptionReader::reject_unknown_keys() const {
  for (const auto& [key, value] : unvisited())
    throw usage_error(ini_.where(section_, key), "unknown key", expected_name(key, known_));
}

void OptionLister::visit(const Option& option) {
  const std::string value = option.text();
  std::string row = "  " + option.key + " = " + (value.empty() ? "(none)" : value);
  if (option.unit != "-") row += " " + option.unit;
  row.resize(std::max<std::size_t>(row.size() + 1, 34), ' ');
  text_ += row + option.help + " (" + option.expected() + ")\n";
}

OptionLocation location_in(const IniFile& ini, const std::string& section) {
  return [ini, section](const std::string& key) {
    return key.empty() ? ini.where(section) : ini.where(section, key);
  };
}

OptionLocation location_of(const std::string& maker) {
  return [maker](const std::string& key) { return key.empty() ? maker : maker + "." + key; };
}

}  // namespace slalom
