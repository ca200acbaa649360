// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/world_import.h>

#include <string>

namespace slalom {

/// A world of Stage, see import_world(). Bitmaps and included files are looked for relative to it.
ImportedWorld stage_world(const std::string& path, const WorldOptions& options);

}  // namespace slalom
