#pragma once

#include <slalom/gui/scene_layers.h>

namespace slalom {

std::unique_ptr<SceneLayer> make_obstacles_layer();
std::unique_ptr<SceneLayer> make_distance_field_layer();
std::unique_ptr<SceneLayer> make_voronoi_layer();
std::unique_ptr<SceneLayer> make_published_path_layer();
std::unique_ptr<SceneLayer> make_safest_path_layer();
std::unique_ptr<SceneLayer> make_shortest_path_layer();
std::unique_ptr<SceneLayer> make_scan_layer();
std::unique_ptr<SceneLayer> make_trajectories_layer();
std::unique_ptr<SceneLayer> make_ends_layer();

}  // namespace slalom
