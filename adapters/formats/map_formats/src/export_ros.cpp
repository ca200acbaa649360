// SPDX-License-Identifier: BSD-3-Clause
#include "map_writers.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/scenario/occupancy.h>

#include <yaml-cpp/yaml.h>

#include <filesystem>

namespace slalom {
namespace {

/// Gray values of map_server.
constexpr char kFree = static_cast<char>(254), kOccupied = 0;

std::string pgm_of(const Occupancy& cells) {
  std::string pgm =
      "P5\n" + std::to_string(cells.size_x()) + " " + std::to_string(cells.size_y()) + "\n255\n";
  for (int cy = cells.size_y() - 1; cy >= 0; --cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) pgm += cells.occupied(cx, cy) ? kOccupied : kFree;
  return pgm;
}

}  // namespace

void write_ros_map(const Scenario& scenario, const MapExportOptions& options,
                   const std::string& path) {
  const Scenario grid = convert(scenario, Representation::Grid, options.resolution);
  const Occupancy cells = make_occupancy(grid, options.resolution);
  const std::string image = without_extension(path, ".yaml") + ".pgm";
  YAML::Emitter name;
  name << YAML::DoubleQuoted << std::filesystem::path(image).filename().string();
  std::string yaml = std::string("image: ") + name.c_str() + "\n";
  yaml += "mode: trinary\n";
  yaml += "resolution: " + format_number(cells.resolution()) + "\n";
  yaml += "origin: [" + format_number(cells.origin().x) + ", " + format_number(cells.origin().y) +
          ", 0]\n";
  yaml += "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  write_file_atomically(image, pgm_of(cells));
  write_file_atomically(path, yaml);
  write_map_task(grid, path);
}

}  // namespace slalom
