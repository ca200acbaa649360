// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/import_scenarios.h>

namespace slalom {

void ImportRequest::visit_pairs(OptionVisitor& v) {
  v.option("start", start, "start pose x,y,phi (m, rad) on each map");
  v.option("goal", goal, "goal x,y (m) on each map, and x,y,phi (rad) if it has a heading");
  v.option("pairs", pairs,
           "number of solvable pairs of start and goal to sample on each map, or a file of them");
  v.option("seed", seed, "seed of the pairs");
  v.option("robot_radius", robot_radius, "m", "robot radius for which pairs are solvable",
           Range::positive());
  v.option("min_distance", limits.min_distance, "m", "straight-line distance of sampled pairs",
           Range::at_least(0));
  v.option("max_distance", limits.max_distance, "m",
           "straight-line distance of sampled pairs; default: no limit", Range::positive());
  v.option("min_path", limits.min_length, "m", "shortest path length of sampled pairs",
           Range::at_least(0));
  v.option("max_path", limits.max_length, "m",
           "shortest path length of sampled pairs; default: no limit", Range::positive());
  v.option("min_detour", limits.min_detour, "-", "shortest path length / straight-line distance",
           Range::positive());
  v.option("max_detour", limits.max_detour, "-",
           "shortest path length / straight-line distance; default: no limit", Range::positive());
}

void ImportRequest::visit_maps(OptionVisitor& v) {
  v.option("unknown_free", map.unknown_is_free, "unknown cells are free");
  v.option("simplemap_resolution", map.simplemap_resolution, "m",
           "cell size of grids built from simplemaps and logs", Range::positive());
  v.option("image_resolution", map.image.resolution, "m",
           "pixel size of images; required for images", Range::at_least(0));
  v.option("image_threshold", map.image.threshold, "-",
           "gray value below which a pixel is an obstacle", Range::between(1, 255));
  v.option("image_negate", map.image.negate, "light pixels are obstacles instead of dark ones");
  v.option("margin", points.margin, "m", "margin of the workspace around point maps and worlds",
           Range::positive());
  v.option("z_min", points.z_min, "m",
           "minimum height of obstacles; default: no limit in point maps, 0.05 m in worlds");
  v.option("z_max", points.z_max, "m",
           "maximum height of obstacles; default: no limit in point maps, 2 m in worlds");
}

void ImportRequest::visit_data_sets(OptionVisitor& v) {
  v.option("worlds", barn.worlds,
           "BARN: worlds of a folder, such as 0-9,20 or 0-299/even; default: all");
  v.option("task", barn.task, "BARN: start and goal of the challenge or of the published trials");
  v.option("barn_grid", barn_as_grid, "BARN: grid with cells of 0.15 m instead of cylinders");
  v.option("scan", topics.scan, "bags: topic with LaserScan; default: the only one");
  v.option("odom", topics.odometry,
           "bags: topic with Odometry; default: the only one, or else the transform from odom");
  v.option("base", topics.base, "bags: frame of the robot's center; default: base_link");
  v.option("cell_size", map.cell_size, "m",
           "MovingAI: cell size of the map; required for MovingAI maps", Range::at_least(0));
  v.option("scen", problems, "MovingAI: file of start and goal pairs; pairs is their number");
  v.option("buckets", buckets,
           "MovingAI: difficulties of the pairs, such as 3 or 0-10; default: all");
}

void ImportRequest::visit(OptionVisitor& v) {
  visit_pairs(v);
  visit_maps(v);
  visit_data_sets(v);
}

}  // namespace slalom
