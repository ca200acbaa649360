#include "layers/layers.h"

namespace slalom {

SceneLayers make_scene_layers() {
  SceneLayers layers;
  for (const auto make :
       {make_obstacles_layer, make_distance_field_layer, make_voronoi_layer,
        make_published_path_layer, make_safest_path_layer, make_shortest_path_layer,
        make_scan_layer, make_trajectories_layer, make_ends_layer})
    layers.push_back(make());
  return layers;
}

}  // namespace slalom
