// SPDX-License-Identifier: BSD-3-Clause
#include "ros2_link.h"

#include <slalom/core/text.h>

#include <map>
#include <stdexcept>

namespace slalom {
namespace {

/// A number or truth value as it is, else a text in quotes.
std::string yaml_value(const std::string& value) {
  double number = 0;
  if (value == "true" || value == "false" || parse_number(value, number)) return value;
  std::string quoted = "'";
  for (const char letter : value) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

}  // namespace

std::string ros_name(const Ros2Options& options, const std::string& name) {
  if (starts_with(name, "/")) return name;
  const std::string& space = options.name_space;
  return (space.empty() || space.front() == '/' ? space : "/" + space) + "/" + name;
}

std::vector<std::string> barrier_nodes(const Ros2Options& options) {
  std::vector<std::string> nodes;
  for (const std::string& node : split(options.barrier, ','))
    nodes.push_back(ros_name(options, node));
  return nodes;
}

std::vector<NodeParameter> node_parameters(const Ros2Options& options) {
  std::vector<NodeParameter> parameters;
  for (const std::string& assignment : split_nonempty(options.parameter_set, ';')) {
    const std::size_t equal = assignment.find('='), dot = assignment.find('.');
    if (equal == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equal)
      throw std::invalid_argument(assignment);
    parameters.push_back({ros_name(options, trim(assignment.substr(0, dot))),
                          trim(assignment.substr(dot + 1, equal - dot - 1)),
                          trim(assignment.substr(equal + 1))});
  }
  return parameters;
}

std::string parameter_file_text(const std::vector<NodeParameter>& parameters) {
  std::map<std::string, std::string> nodes;
  for (const NodeParameter& one : parameters)
    nodes[one.node] += "    " + one.name + ": " + yaml_value(one.value) + "\n";
  std::string text;
  for (const auto& [node, lines] : nodes) text += node + ":\n  ros__parameters:\n" + lines;
  return text;
}

}  // namespace slalom
