// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/ros_parameters/parameter_table.h>

#include <string>
#include <vector>

namespace slalom::ros {

/// A controller in files of parameters.
struct Controller {
  std::string name;   ///< "FollowPath"
  std::string path;   ///< of its section, with dots
  std::string kind;   ///< its class, or its name in move_base
  std::string where;  ///< of its class
};

/// The parameters of files of Nav2 or move_base: keys below sections, without namespaces,
/// `ros__parameters` and repeated names of nodes.
class ParameterFiles {
 public:
  /// A later file replaces values of an earlier one. Throws Error (File) for a file that cannot be
  /// read, is not YAML, is too deep or has too many values.
  static ParameterFiles load(const std::vector<std::string>& paths);

  std::vector<Controller> controllers() const;
  std::vector<RosParameter> below(const std::string& path) const;  ///< with keys relative to it
  /// The parameters of a node, in whatever namespace; for move_base also those without a section.
  /// Throws Error (Usage) for a node in several namespaces.
  std::vector<RosParameter> of_node(RosFamily family) const;

 private:
  std::vector<RosParameter> parameters_;  // keys are complete paths
};

}  // namespace slalom::ros
