#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <mrpt/config/config_parser.h>

#include <algorithm>
#include <fstream>
#include <numeric>
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

/// Expands @define and ${}, line by line counted: MRPT's parser keeps the number of lines.
std::string expand(const std::string& text, const std::string& name) {
  try {
    return mrpt::config::config_parser(text);
  } catch (const std::exception& e) {
    throw usage_error(name, "cannot expand definitions (" + reason_of(e) + ")",
                      "@define NAME VALUE and ${NAME}");
  }
}

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

std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 2) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

IniFile IniFile::load(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw file_error(path, "cannot be read", "a configuration file (.ini)");
  std::stringstream content;
  content << file.rdbuf();
  if (file.bad()) throw file_error(path, "cannot be read", "a configuration file (.ini)");
  return from_text(content.str(), path);
}

IniFile IniFile::from_text(const std::string& text, const std::string& name) {
  IniFile ini;
  ini.name_ = name;
  std::istringstream lines(expand(text, name));
  std::string raw, section;
  for (int number = 1; std::getline(lines, raw); ++number) {
    const std::string place = name + ":" + std::to_string(number);
    const std::string line = trim(strip_comment(raw));
    if (line.empty() || line[0] == '@') continue;
    if (line.front() == '[') {
      if (line.back() != ']') throw usage_error(place, "'" + line + "' is not closed", "[section]");
      section = trim(line.substr(1, line.size() - 2));
      if (ini.section_where_.emplace(section, place).second) ini.section_order_.push_back(section);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || section.empty())
      throw usage_error(place, "'" + line + "' is neither a section nor a key of one",
                        "[section] or key = value");
    const std::string key = trim(line.substr(0, equals));
    if (ini.find(section, key) != nullptr)
      throw usage_error(place + ": [" + section + "] " + key, "key given twice", "it once");
    ini.entries_[section].push_back(
        {key, trim(line.substr(equals + 1)), place + ": [" + section + "] " + key});
  }
  return ini;
}

void IniFile::override_key(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot =
      equals == std::string::npos ? equals : assignment.substr(0, equals).rfind('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == equals)
    throw usage_error("--set " + assignment, "not an assignment", "SECTION.KEY=VALUE");
  set(trim(assignment.substr(0, dot)), trim(assignment.substr(dot + 1, equals - dot - 1)),
      trim(assignment.substr(equals + 1)));
}

std::vector<std::string> IniFile::sections() const {
  return section_order_;
}

std::vector<std::string> IniFile::keys(const std::string& section) const {
  std::vector<std::string> keys;
  const auto found = entries_.find(section);
  if (found == entries_.end()) return keys;
  for (const Entry& entry : found->second) keys.push_back(entry.key);
  return keys;
}

bool IniFile::has_section(const std::string& section) const {
  return section_where_.count(section) > 0;
}

std::optional<std::string> IniFile::get(const std::string& section, const std::string& key) const {
  const Entry* entry = find(section, key);
  return entry == nullptr ? std::nullopt : std::make_optional(entry->value);
}

void IniFile::set(const std::string& section, const std::string& key, const std::string& value) {
  const std::string place = "--set " + section + "." + key;
  if (section_where_.emplace(section, place).second) section_order_.push_back(section);
  for (Entry& entry : entries_[section]) {
    if (entry.key != key) continue;
    entry.value = value;
    entry.where = place;
    return;
  }
  entries_[section].push_back({key, value, place});
}

void IniFile::remove(const std::string& section, const std::string& key) {
  const auto found = entries_.find(section);
  if (found == entries_.end()) return;
  std::vector<Entry>& entries = found->second;
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                               [&](const Entry& entry) { return entry.key == key; }),
                entries.end());
}

std::string IniFile::where(const std::string& section, const std::string& key) const {
  const Entry* entry = find(section, key);
  return entry == nullptr ? name_ + ": [" + section + "] " + key : entry->where;
}

std::string IniFile::where(const std::string& section) const {
  const auto found = section_where_.find(section);
  return (found == section_where_.end() ? name_ : found->second) + ": [" + section + "]";
}

std::string IniFile::canonical_text() const {
  std::string text;
  for (const auto& [section, entries] : entries_) {
    text += "[" + section + "]\n";
    std::vector<Entry> sorted = entries;
    std::sort(sorted.begin(), sorted.end(),
              [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (const Entry& entry : sorted) text += entry.key + " = " + entry.value + "\n";
  }
  return text;
}

void IniFile::reject_unknown_sections(const std::vector<std::string>& accepted) const {
  for (const std::string& section : section_order_) {
    const bool known = std::any_of(accepted.begin(), accepted.end(), [&](const std::string& name) {
      const bool prefix = name.size() > 2 && name.compare(name.size() - 2, 2, ".*") == 0;
      return prefix ? section.compare(0, name.size() - 1, name, 0, name.size() - 1) == 0
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
  for (const Entry& entry : found->second)
    if (entry.key == key) return &entry;
  return nullptr;
}

}  // namespace slalom
