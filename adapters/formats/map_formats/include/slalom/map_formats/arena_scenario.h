// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/world_import.h>

namespace slalom {

/// Whether the name of a file is that of a scenario of Arena (.json).
bool is_arena_scenario(const std::string& path);

/// Reads a scenario of Arena-Rosnav, WORLD/scenarios/NAME.json, with its map WORLD/map/map.yaml:
/// the start and the goal of the first robot, and people as moving obstacles, which walk from their
/// position along their waypoints and back to it in a loop, at `vmax` or 1 m/s. The name is
/// WORLD_NAME. Other robots and obstacles of models are left out, as the message says. Throws Error
/// (File): file, place, what was expected.
ImportedWorld import_arena_scenario(const std::string& path, const MapImportOptions& options);

}  // namespace slalom
