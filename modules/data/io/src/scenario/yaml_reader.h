// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace slalom {

std::string yaml_list(std::initializer_list<double> numbers);  ///< [1, 2.5]
std::string yaml_text(const std::string& text);                ///< in quotes

/// Reads the keys and values of a node; errors contain the line.
class YamlReader {
 public:
  YamlReader(const YAML::Node& root, std::string where) : root_(root), where_(std::move(where)) {}

  const YAML::Node& root() const { return root_; }
  const std::string& where() const { return where_; }

  Error error(const YAML::Node& node, const std::string& what, const std::string& expected) const;
  void expect(bool condition, const YAML::Node& node, const std::string& what,
              const std::string& expected) const;
  void reject_unknown_keys(const std::vector<std::string>& known) const;
  YAML::Node required(const std::string& key) const;
  std::string text(const std::string& key) const;
  YAML::Node sequence(const std::string& key) const;
  double number(const YAML::Node& node) const;
  std::vector<double> numbers(const YAML::Node& node, std::size_t count) const;

 private:
  YAML::Node root_;
  std::string where_;
};

}  // namespace slalom
