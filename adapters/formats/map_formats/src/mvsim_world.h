// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/world_import.h>

#include <string>

namespace slalom {

class XmlFile;

/// A world of mvsim, see import_world(). Its maps are looked for relative to `path`.
ImportedWorld mvsim_world(const XmlFile& file, const std::string& path,
                          const WorldOptions& options);

}  // namespace slalom
