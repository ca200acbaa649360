// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/option.h>

#include <string>
#include <vector>

namespace slalom {

/// The keys that name files of parameters, in [simulation], [robot], [sensor] and [method.NAME].
struct RosParameterSource {
  std::string from;        ///< files, comma-separated
  std::string controller;  ///< of the files; empty: the only one

  void visit(OptionVisitor& v);
};

/// The fate of the parameters of one section with `from`.
struct RosParameterReport {
  /// A value of the file that the .ini overrides.
  struct Edit {
    std::string file;
    int line, column;  ///< from 0
    std::string old_text, new_text;
  };
  struct Line {
    std::string parameter;  ///< "FollowPath.max_vel_x = 0.26"
    std::string result;     ///< "max_v = 0.26", or the reason
  };
  std::string section, source;  ///< "method.dwb"; "nav2.yaml, FollowPath (CLASS)"
  std::vector<Line> mapped, overridden, without_counterpart;
  std::vector<Edit> edits;
  std::vector<std::string> not_in_file;  ///< "FollowPath.sim_time: 2", of keys of the .ini
  std::vector<std::string> no_way_back;  ///< keys of the .ini that no parameter gives exactly
  std::vector<std::string> unknown;      ///< "FILE:LINE: SECTION.KEY"
  std::vector<std::string> repeated;     ///< the same, of values that replace one in another line

  std::string summary() const;  ///< one line
  std::string listing() const;  ///< all lines
};

/// Replaces `from` and `controller` by the keys that follow from the files, except keys that the
/// section has. A robot in URDF gives shape, lasers ([laser.NAME]) and limits. Throws Error: (File)
/// for a file that cannot be read, (Usage) for a value that cannot be converted, a controller that
/// is not in the files or that has no method here.
std::vector<RosParameterReport> resolve_ros_parameters(IniFile& ini);

/// A file of parameters and its text with the overridden values.
struct EditedRosParameters {
  std::string file, text, diff;  ///< as ros_parameter_diff()
};

/// The files with overridden values. Throws as ros_parameter_diff().
std::vector<EditedRosParameters> edit_ros_parameters(
    const std::vector<RosParameterReport>& reports);

/// The overridden values of all sections as a unified diff of their files, for `patch`; "" if there
/// are none. Throws Error (Usage) where sections differ in a value, (File) for a value that is not
/// in its line as it is written in plain YAML.
std::string ros_parameter_diff(const std::vector<RosParameterReport>& reports);

}  // namespace slalom
