// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_reader.h"

#include <slalom/core/text.h>

namespace slalom {

std::string yaml_list(std::initializer_list<double> numbers) {
  std::vector<std::string> parts;
  for (const double number : numbers) parts.push_back(format_number(number));
  return "[" + join(parts, ", ") + "]";
}

std::string yaml_text(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

Error YamlReader::error(const YAML::Node& node, const std::string& what,
                        const std::string& expected) const {
  const int line = node.Mark().line + 1;
  return file_error(line > 0 ? where_ + ":" + std::to_string(line) : where_, what, expected);
}

void YamlReader::expect(bool condition, const YAML::Node& node, const std::string& what,
                        const std::string& expected) const {
  if (!condition) throw error(node, what, expected);
}

void YamlReader::reject_unknown_keys(const std::vector<std::string>& known) const {
  for (const auto& entry : root_) {
    const auto key = entry.first.as<std::string>();
    if (contains(known, key)) continue;
    throw error(entry.first, "unknown key '" + key + "'", expected_name(key, known));
  }
}

YAML::Node YamlReader::required(const std::string& key) const {
  const YAML::Node node = root_[key];
  expect(node.IsDefined() && !node.IsNull(), root_, "missing key '" + key + "'", key);
  return node;
}

std::string YamlReader::text(const std::string& key) const {
  const YAML::Node node = required(key);
  expect(node.IsScalar(), node, "'" + key + "' is not a string", "a string");
  return node.as<std::string>();
}

YAML::Node YamlReader::sequence(const std::string& key) const {
  const YAML::Node node = required(key);
  expect(node.IsSequence(), node, "'" + key + "' is not a list", "a list");
  return node;
}

double YamlReader::number(const YAML::Node& node) const {
  double value = 0;
  expect(node.IsScalar() && parse_number(node.as<std::string>(), value), node, "invalid number",
         "a finite number");
  return value;
}

std::vector<double> YamlReader::numbers(const YAML::Node& node, std::size_t count) const {
  expect(node.IsSequence() && node.size() == count, node, "malformed list",
         "[" + std::to_string(count) + " numbers]");
  std::vector<double> values;
  for (const auto& item : node) values.push_back(number(item));
  return values;
}

}  // namespace slalom
