// SPDX-License-Identifier: BSD-3-Clause
#include "map_writers.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/png_scene.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>

#include <filesystem>

namespace slalom {
namespace {

void write_yaml(const Scenario& scenario, const MapExportOptions& /*options*/,
                const std::string& path) {
  write_file_atomically(path, scenario_to_yaml(scenario));
}

void write_svg(const Scenario& scenario, const MapExportOptions& /*options*/,
               const std::string& path) {
  write_file_atomically(path, render_svg(scenario, {}));
}

void write_png(const Scenario& scenario, const MapExportOptions& /*options*/,
               const std::string& path) {
  SceneOptions options;
  options.max_pixels = 800;
  render_png(scenario, options, path);
}

std::string left_out(const Scenario& scenario, const ExportFormat& format) {
  std::vector<std::string> parts;
  if (!scenario.movers().empty() && !format.has_movers)
    parts.push_back(count_text(scenario.movers().size(), "moving obstacle"));
  const std::size_t people = format.has_people ? 0 : scenario.people().size();
  if (people > 0) parts.push_back(std::to_string(people) + (people == 1 ? " person" : " people"));
  if (parts.empty()) return "";
  return "scenario " + scenario.name() + ": " + join(parts, " and ") + " left out, the format " +
         format.name + (format.has_movers ? " has no people" : " has static obstacles only");
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats = {
      {"yaml", ".yaml", "the complete scenario as YAML", write_yaml, true, true},
      {"ros", ".yaml", "ROS map_server YAML with a PGM", write_ros_map},
      {"mrpt", ".gridmap.gz", "MRPT occupancy grid", write_mrpt_map},
      {"mvsim", ".xml", "mvsim world with an occupancy grid", write_mvsim_world},
      {"svg", ".svg", "image", write_svg, true},
      {"png", ".png", "image", write_png, true},
  };
  return formats;
}

std::string export_scenario(const Scenario& scenario, const std::string& format,
                            const MapExportOptions& options, const std::string& path) {
  std::vector<std::string> names;
  for (const ExportFormat& known : export_formats()) {
    names.push_back(known.name);
    if (known.name != format) continue;
    const bool no_extension = std::filesystem::path(path).extension().empty();
    const std::string file = no_extension ? path + known.ending : path;
    if (!ends_with(file, known.ending))
      throw usage_error(path, "wrong extension for the format " + format,
                        "a name with " + known.ending);
    known.write(scenario, options, file);
    return left_out(scenario, known);
  }
  throw usage_error("format", "unknown format '" + format + "'", "one of " + join(names, ", "));
}

std::string without_extension(const std::string& path, const std::string& ending) {
  return ends_with(path, ending) ? path.substr(0, path.size() - ending.size()) : path;
}

}  // namespace slalom
