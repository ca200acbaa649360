// SPDX-License-Identifier: BSD-3-Clause
#include "make_list.h"

#include <slalom/app/import_scenarios.h>
#include <slalom/app/program.h>
#include <slalom/core/printable.h>

#include <iostream>

namespace slalom {
namespace {

struct ImportArguments {
  ImportRequest request;
  std::string output;
  bool quiet = false;
};

void import(const ImportArguments& arguments) {
  const auto progress = make_silent_progress();
  ImportedScenarios imported = import_scenarios(arguments.request, *progress);
  for (const std::string& message : imported.messages)
    if (!arguments.quiet) std::cerr << printable_line(message) << "\n";
  write_scenarios(arguments.output, std::move(imported.scenarios), imported.notes, arguments.quiet);
}

void add_pair_options(CLI::App& verb, ImportRequest& request) {
  verb.add_option("--start", request.start, "Start pose x,y,phi (m, rad)");
  verb.add_option("--goal", request.goal, "Goal x,y (m), or x,y,phi (rad) with a heading");
  verb.add_option("--pairs", request.pairs, "Number of solvable pairs to sample on each map")
      ->check(CLI::PositiveNumber);
  verb.add_option("--seed", request.seed, "Seed of the pairs")->capture_default_str();
  verb.add_option("--robot-radius", request.robot_radius, "Radius of the robot, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// Constraints on sampled pairs.
void add_limit_options(CLI::App& verb, TaskConstraints& limits) {
  verb.add_option("--min-distance", limits.min_distance, "Straight-line distance, m")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb.add_option("--max-distance", limits.max_distance, "Straight-line distance, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--min-path", limits.min_length, "Shortest path length, m")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--max-path", limits.max_length, "Shortest path length, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--min-detour", limits.min_detour,
                  "Shortest path length / straight-line distance")
      ->check(CLI::PositiveNumber);
  verb.add_option("--max-detour", limits.max_detour,
                  "Shortest path length / straight-line distance")
      ->check(CLI::PositiveNumber);
}

void add_map_options(CLI::App& verb, ImportRequest& request) {
  MapImportOptions& map = request.map;
  verb.add_option("--simplemap-resolution", map.simplemap_resolution,
                  "Cell size of grids built from simplemaps and logs, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_flag("--unknown-free", map.unknown_is_free, "Unknown cells are free");
  verb.add_option("--image-resolution", map.image.resolution, "Pixel size of images, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--image-threshold", map.image.threshold,
                  "Gray value below which a pixel is an obstacle")
      ->check(CLI::Range(1, 255))
      ->capture_default_str();
  PointMapOptions& points = request.points;
  verb.add_option("--margin", points.margin,
                  "Margin of the workspace around point maps and worlds, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--z-min", points.z_min,
                  "Minimum height of obstacles in point maps and worlds (0.05), m");
  verb.add_option("--z-max", points.z_max,
                  "Maximum height of obstacles in point maps and worlds (2), m");
  verb.add_flag("--image-negate", map.image.negate,
                "Light pixels are obstacles instead of dark ones");
}

void add_data_set_options(CLI::App& verb, ImportRequest& request) {
  verb.add_option("--worlds", request.barn.worlds,
                  "BARN: worlds of a folder, such as 0-9,20 or 0-299/even (default: all)");
  add_choice(
      verb, "--task", request.barn.task,
      "BARN: start and goal of the challenge (default) or of the trials with published times");
  verb.add_flag("--barn-grid", request.barn_as_grid,
                "BARN: grid with cells of 0.15 m instead of cylinders");
  verb.add_option("--scan", request.topics.scan,
                  "Bags: topic with LaserScan (default: the only one)");
  verb.add_option("--odom", request.topics.odometry,
                  "Bags: topic with Odometry (default: the only one, or the transform from odom)");
  verb.add_option("--base", request.topics.base,
                  "Bags: frame of the robot's center (default: base_link)");
  verb.add_option("--cell-size", request.map.cell_size, "MovingAI: cell size of the map, m")
      ->check(CLI::PositiveNumber);
  verb.add_option("--scen", request.problems,
                  "MovingAI: file of start and goal pairs; --pairs is their number");
  verb.add_option("--buckets", request.buckets,
                  "MovingAI: difficulties of the pairs, such as 3 or 0-10");
}

}  // namespace

void add_import_verb(CLI::App& app) {
  static ImportArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "import",
      "Import maps (MRPT, ROS, MovingAI, images), worlds (Gazebo, Stage, mvsim, ir-sim, BARN), "
      "scenarios of Arena (.json), "
      "logs (.rawlog, bags) or scenarios (.scenario.yaml)");
  verb->add_option("files", arguments.request.files,
                   "Map files, worlds, .scenario.yaml files, .json of Arena, BARN grids or "
                   "folders, rawlogs, bags")
      ->required();
  verb->add_option("-o,--output", arguments.output, "The list to write (.scenarios)")->required();
  add_pair_options(*verb, arguments.request);
  add_limit_options(*verb, arguments.request.limits);
  add_map_options(*verb, arguments.request);
  add_data_set_options(*verb, arguments.request);
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { import(arguments); });
}

}  // namespace slalom
