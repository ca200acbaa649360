// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/expect_text.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/printable.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>

#include <mrpt/config/config_parser.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace slalom {
namespace {

std::string strip_comment(const std::string& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool starts_comment = line[i] == '#' || line[i] == ';' || line.compare(i, 2, "//") == 0;
    const bool after_blank = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
    if (starts_comment && after_blank) return line.substr(0, i);
  }
  return line;
}

/// Expands @define and ${}. MRPT's parser keeps line numbers.
std::string expand(const std::string& text, const std::string& name) {
  try {
    return mrpt::config::config_parser(text);
  } catch (const std::exception& e) {
    throw usage_error(name, "cannot expand definitions (" + reason_of(e) + ")",
                      "@define NAME VALUE and ${NAME}");
  }
}

/// Values become names in files, which are UTF-8.
void expect_utf8(const std::string& text, const std::string& where) {
  if (const auto at = find_invalid_utf8(text))
    throw usage_error(where, "byte " + std::to_string(*at + 1) + " of '" + text + "' is not UTF-8",
                      "text in UTF-8");
}

}  // namespace

IniFile IniFile::load(const std::string& path) {
  const std::string kind = "a configuration file (.ini)";
  const std::string text = read_text(path, kind, kMaxConfigSize);
  if (!is_text(text)) throw file_error(path, "is not a text file", kind);
  return from_text(text, path);
}

IniFile IniFile::from_text(const std::string& text, const std::string& name) {
  IniFile ini;
  ini.name_ = name;
  std::istringstream lines(expand(text, name));
  std::string raw, section;
  for (int number = 1; std::getline(lines, raw); ++number) {
    const std::string position = name + ":" + std::to_string(number);
    const std::string line = trim(strip_comment(raw));
    if (line.empty() || line[0] == '@') continue;
    expect_utf8(line, position);
    if (line.front() == '[') {
      if (line.back() != ']')
        throw usage_error(position, "missing ']' in '" + line + "'", "[section]");
      section = trim(line.substr(1, line.size() - 2));
      expect_name(section.substr(section.find('.') + 1), "a section");
      if (ini.section_where_.emplace(section, position).second)
        ini.section_order_.push_back(section);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos && section.empty())
      throw usage_error(position, "'" + line + "' is of no section", "a line [section] before it");
    if (equals == std::string::npos)
      throw usage_error(position, "malformed line '" + line + "'", "[section] or key = value");
    const std::string key = trim(line.substr(0, equals));
    const std::string where = position + ": [" + section + "] " + key;
    const Entry entry = {trim(line.substr(equals + 1)), where, ini.count_++, false};
    if (!ini.entries_[section].emplace(key, entry).second)
      throw usage_error(where, "duplicate key", "one value");
  }
  return ini;
}

void IniFile::override_key(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos && assignment.find('.') != std::string::npos)
    throw usage_error("--set " + assignment, "no value", assignment + "=VALUE");
  // Keys of [tune] have dots themselves: SECTION.KEY of a configuration.
  const std::string name = equals == std::string::npos ? "" : assignment.substr(0, equals);
  const std::size_t dot = starts_with(name, "tune.") ? name.find('.') : name.rfind('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == equals)
    throw usage_error("--set " + assignment, "not an assignment", "SECTION.KEY=VALUE");
  expect_utf8(assignment, "--set");
  set(trim(assignment.substr(0, dot)), trim(assignment.substr(dot + 1, equals - dot - 1)),
      trim(assignment.substr(equals + 1)));
}

std::vector<std::string> IniFile::sections() const {
  return section_order_;
}

std::vector<std::string> IniFile::keys(const std::string& section) const {
  std::map<std::size_t, std::string> by_number;
  const auto found = entries_.find(section);
  if (found == entries_.end()) return {};
  for (const auto& [key, entry] : found->second) by_number.emplace(entry.number, key);
  std::vector<std::string> keys;
  for (const auto& [number, key] : by_number) keys.push_back(key);
  return keys;
}

bool IniFile::has_section(const std::string& section) const {
  return section_where_.count(section) > 0;
}

std::optional<std::string> IniFile::get(const std::string& section, const std::string& key) const {
  const Entry* entry = find(section, key);
  return entry == nullptr ? std::nullopt : std::make_optional(entry->value);
}

bool IniFile::can_hold(const std::string& value) {
  try {
    return from_text("[a]\nb = " + value).get("a", "b") == value;
  } catch (const Error&) {
    return false;
  }
}

void IniFile::set(const std::string& section, const std::string& key, const std::string& value,
                  const std::string& origin) {
  const std::string position = origin + section + "." + key;
  const bool overridden = origin == kOverride;
  if (section_where_.emplace(section, position).second) section_order_.push_back(section);
  const auto [found, is_new] =
      entries_[section].try_emplace(key, Entry{value, position, count_, overridden});
  if (is_new)
    ++count_;
  else
    found->second = {value, position, found->second.number, overridden};
}

void IniFile::remove(const std::string& section, const std::string& key) {
  const auto found = entries_.find(section);
  if (found != entries_.end()) found->second.erase(key);
}

bool IniFile::is_overridden(const std::string& section, const std::string& key) const {
  const Entry* entry = find(section, key);
  return entry != nullptr && entry->overridden;
}

std::string IniFile::where(const std::string& section, const std::string& key) const {
  const Entry* entry = find(section, key);
  return entry == nullptr ? name_ + ": [" + section + "] " + key : entry->where;
}

std::string IniFile::where(const std::string& section) const {
  const auto found = section_where_.find(section);
  return (found == section_where_.end() ? name_ : found->second) + ": [" + section + "]";
}

std::string IniFile::folder() const {
  return std::filesystem::path(name_).parent_path().string();
}

std::string IniFile::canonical_text() const {
  std::string text;
  for (const auto& [section, entries] : entries_) {
    text += "[" + section + "]\n";
    for (const auto& [key, entry] : entries) text += key + " = " + entry.value + "\n";
  }
  return text;
}

void IniFile::reject_unknown_sections(const std::vector<std::string>& accepted) const {
  for (const std::string& section : section_order_) {
    const bool known = std::any_of(accepted.begin(), accepted.end(), [&](const std::string& name) {
      return ends_with(name, ".*") ? starts_with(section, name.substr(0, name.size() - 1))
                                   : section == name;
    });
    if (known) continue;
    const std::string nearest = nearest_name(section, accepted);
    throw usage_error(where(section), "unknown section",
                      nearest.empty() ? "one of " + join(accepted, ", ") : "[" + nearest + "]");
  }
}

const IniFile::Entry* IniFile::find(const std::string& section, const std::string& key) const {
  const auto found = entries_.find(section);
  if (found == entries_.end()) return nullptr;
  const auto entry = found->second.find(key);
  return entry == found->second.end() ? nullptr : &entry->second;
}

}  // namespace slalom
