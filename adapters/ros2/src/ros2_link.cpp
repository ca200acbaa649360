// SPDX-License-Identifier: BSD-3-Clause
#include "ros2_link.h"

#include <slalom/core/text.h>

namespace slalom {

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

}  // namespace slalom
