// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_import.h>
#include <slalom/map_formats/moving_ai.h>
#include <slalom/scenario/grid_map.h>

namespace slalom {
namespace {

bool ends_with_any(const std::string& text, std::initializer_list<const char*> ends) {
  for (const char* end : ends)
    if (ends_with(text, end)) return true;
  return false;
}

}  // namespace

mrpt::maps::COccupancyGridMap2D load_map(const std::string& path, const MapImportOptions& options) {
  mrpt::maps::COccupancyGridMap2D map;
  if (ends_with_any(path, {".gridmap", ".gridmap.gz"})) {
    map = read_gridmap(path);
  } else if (ends_with_any(path, {".simplemap", ".simplemap.gz"})) {
    map = read_simplemap(path, options.simplemap_resolution);
  } else if (ends_with_any(path, {".yaml", ".yml"})) {
    map = read_ros_map(path, options.notes);
  } else if (ends_with(path, ".map")) {
    map = read_moving_ai_map(path, options.cell_size);
  } else if (ends_with_any(path, {".pgm", ".png", ".jpg", ".jpeg", ".bmp"})) {
    map = read_image_map(path, options.image);
  } else {
    throw file_error(
        path, "unknown map format",
        ".gridmap[.gz], .simplemap[.gz], a ROS map_server .yaml, a MovingAI .map, an image (.pgm, "
        ".png, .jpg, .bmp), a world (.world, .sdf, .xml) or a folder of BARN");
  }
  if (options.unknown_is_free) set_unknown_free(map);
  return map;
}

mrpt::maps::COccupancyGridMap2D load_occupancy_grid(const std::string& path) {
  return load_map(path, {});
}

}  // namespace slalom
