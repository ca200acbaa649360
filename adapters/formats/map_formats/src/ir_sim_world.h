// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/world_import.h>

#include <string>

namespace slalom {

/// Whether this is a YAML file with a key `world` and none of a map of ROS.
bool is_ir_sim(const std::string& path);

/// A world of ir-sim, see import_world().
ImportedWorld ir_sim_world(const std::string& path, const WorldOptions& options);

}  // namespace slalom
