// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/library/library_method.h>
#include <slalom/methods/registry.h>
#include <slalom/robot/robot_model.h>

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/math/TPoint2D.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

class NotedConfig;

/// The options of an adapter, with the paths of `config` and `plugin` resolved as those of other
/// methods. Throws Error (Usage).
template <typename Options>
Options read_mrpt_options(const IniFile& ini, const std::string& section) {
  auto options = read_adapter_options<Options>(ini, section);
  if (!options.config.empty())
    options.config =
        resolve_method_file("config", options.config, ini.folder(), ini.where(section, "config"));
  if (!options.plugin.empty()) options.plugin = resolve_plugin_path(ini, section, "plugin");
  return options;
}

/// Reads the file and expands its definitions. Throws Error (File) if it cannot be read.
mrpt::config::CConfigFileMemory read_navigator_config(const std::string& path);

/// Applies overrides "SECTION.KEY=VALUE; ...". Throws Error (Usage) at `where` for malformed
/// assignments and unknown sections.
void override_config(mrpt::config::CConfigFileBase& config, const std::string& assignments,
                     const std::string& where);

/// Throws Error (Usage) at `where` for an override whose key was not read.
void require_overrides(const NotedConfig& config, const std::string& assignments,
                       const std::string& where);

/// The value of "SECTION.KEY" with these overrides; none if it is in neither.
std::optional<std::string> value_of_key(const mrpt::config::CConfigFileBase& config,
                                        const std::string& assignments, const std::string& name,
                                        const std::string& where);

/// Returns the outline of the robot enlarged by `margin`, counter-clockwise. A disc becomes a
/// circumscribed polygon with 16 corners, at most 2 % larger.
std::vector<mrpt::math::TPoint2D> enlarged_outline(const Footprint& shape, double margin);

/// Writes the robot's shape, enlarged by `margin` (m), and its limits to the keys of MRPT's
/// navigators, and unchanged to a section [slalom_robot] for other navigators.
void write_robot(mrpt::config::CConfigFileBase& config, const RobotModel& robot, double margin);

}  // namespace slalom
