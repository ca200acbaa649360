// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>

#include <optional>
#include <string>

namespace slalom {

/// The value of an option of a method of an .ini: a key of its section, SECTION.KEY of the
/// configuration of its MRPT class, or parameter NODE.NAME of its nodes of ROS 2; none if neither
/// the .ini nor that configuration has it. Throws Error: Usage at `where` for SECTION.KEY of
/// another adapter, File for what cannot be read.
std::optional<std::string> get_method_option(const IniFile& ini, const std::string& method,
                                             const std::string& option, const std::string& where);

/// Sets it; SECTION.KEY in config_set, NODE.NAME in parameter_set.
void set_method_option(IniFile& ini, const std::string& method, const std::string& option,
                       const std::string& value);

}  // namespace slalom
