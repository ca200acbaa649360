// SPDX-License-Identifier: BSD-3-Clause
#include "map_writers.h"

#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/map_formats/map_task.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <mrpt/core/bits_math.h>

#include <filesystem>

namespace slalom {
namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else
      xml += c;
  }
  return xml;
}

/// XML comments must not contain two consecutive dashes.
std::string comment_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && !safe.empty() && safe.back() == '-') safe += ' ';
    safe += c;
  }
  return safe;
}

/// In Slalom the border of the workspace is a wall; mvsim has none, so a border of cells is added.
mrpt::maps::COccupancyGridMap2D walled_grid(const Occupancy& cells) {
  const double resolution = cells.resolution();
  auto map =
      make_grid_map(cells.size_x() + 2, cells.size_y() + 2, resolution, cells.to_world(-1, -1));
  for (int cy = -1; cy <= cells.size_y(); ++cy)
    for (int cx = -1; cx <= cells.size_x(); ++cx)
      if (cells.occupied(cx, cy)) map.setCell(cx + 1, cy + 1, 0.0F);
  return map;
}

std::string element(const char* tag, double value) {
  return std::string("    <") + tag + ">" + format_number(value) + "</" + tag + ">\n";
}

}  // namespace

void write_mvsim_world(const Scenario& scenario, const MapExportOptions& options,
                       const std::string& path) {
  const Occupancy cells = make_occupancy(scenario, options.resolution);
  const std::string grid =
      without_extension(without_extension(path, ".xml"), ".world") + ".gridmap";
  const auto& start = scenario.start();
  const Bounds& b = scenario.bounds();
  std::string xml = "<?xml version=\"1.0\"?>\n<mvsim_world version=\"1.0\">\n";
  xml += "  <!-- Slalom scenario " + comment_text(scenario.name()) + "\n";
  xml += "       start, as an init_pose (m, m, degrees): " + format_number(start.x) + " " +
         format_number(start.y) + " " + format_number(mrpt::RAD2DEG(start.phi)) + "\n";
  xml += "       goal (m, m): " + format_number(scenario.goal().x) + " " +
         format_number(scenario.goal().y);
  if (!scenario.movers().empty())
    xml += "\n       without its moving obstacles: " + std::to_string(scenario.movers().size());
  xml += " -->\n";
  xml += "  <element class=\"occupancy_grid\">\n    <file>" +
         escaped(std::filesystem::path(grid).filename().string()) + "</file>\n  </element>\n";
  xml += "  <element class=\"horizontal_plane\">\n";
  xml += element("x_min", b.x_min) + element("y_min", b.y_min) + element("x_max", b.x_max) +
         element("y_max", b.y_max) + element("z", 0);
  xml += "  </element>\n</mvsim_world>\n";
  write_gridmap(walled_grid(cells), grid);
  write_file_atomically(path, xml);
  write_map_task(scenario, path);
}

}  // namespace slalom
