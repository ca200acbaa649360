#include "views/layers/layers.h"

namespace slalom {

std::vector<SceneLayer> make_scene_layers() {
  return {make_obstacles_layer(),      make_distance_field_layer(), make_voronoi_layer(),
          make_published_path_layer(), make_safest_path_layer(),    make_shortest_path_layer(),
          make_scan_layer(),           make_trajectories_layer(),   make_start_goal_layer()};
}

}  // namespace slalom
