// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/world_import.h>

#include <string>

namespace slalom {

class XmlFile;

/// A world of Gazebo, see import_world(). Models that it includes are looked for beside `path`.
ImportedWorld gazebo_world(const XmlFile& file, const std::string& path,
                           const WorldOptions& options);

}  // namespace slalom
