#pragma once

#include "views/scene_layers.h"

namespace slalom {

SceneLayer make_obstacles_layer();
SceneLayer make_distance_field_layer();
SceneLayer make_voronoi_layer();
SceneLayer make_published_path_layer();
SceneLayer make_safest_path_layer();
SceneLayer make_shortest_path_layer();
SceneLayer make_scan_layer();
SceneLayer make_trajectories_layer();
SceneLayer make_start_goal_layer();

}  // namespace slalom
