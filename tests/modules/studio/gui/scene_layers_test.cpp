// SPDX-License-Identifier: BSD-3-Clause
#include "views/scene_layers.h"

#include <gtest/gtest.h>

#include <set>

namespace slalom {
namespace {

Scenario room(Primitives obstacles = {}) {
  return Scenario::continuous("room", {0, 0, 10, 6}, std::move(obstacles), {1, 3, 0}, {9, 3});
}

ScenePtr all_steps(ScenePtr scene) {
  const auto progress = make_silent_progress();
  while (!scene->complete()) scene = compute_next_step(scene, *progress);
  return scene;
}

const SceneLayer& layer_of(const std::vector<SceneLayer>& layers, const std::string& id) {
  for (const auto& layer : layers)
    if (layer.id == id) return layer;
  throw std::out_of_range(id);
}

TEST(SceneLayers, HaveUniqueIdsAndDefaults) {
  const std::vector<SceneLayer> layers = make_scene_layers();
  std::set<std::string> ids, on;
  for (const auto& layer : layers) {
    EXPECT_FALSE(layer.title.empty());
    EXPECT_TRUE(ids.insert(layer.id).second) << layer.id;
    if (layer.on) on.insert(layer.id);
  }
  EXPECT_EQ(ids,
            (std::set<std::string>{"obstacles", "distance_field", "voronoi", "published", "safest",
                                   "shortest", "scan", "trajectories", "start_goal"}));
  EXPECT_EQ(
      on, (std::set<std::string>{"obstacles", "safest", "shortest", "trajectories", "start_goal"}));
}

TEST(SceneLayers, ReportNotesAndMissingData) {
  const ScenePtr first = prepare_scene(room(), {});
  const std::vector<SceneLayer> layers = make_scene_layers();
  EXPECT_EQ(layer_of(layers, "distance_field").missing_reason(*first, {}), "being computed");
  EXPECT_EQ(layer_of(layers, "published").missing_reason(*first, {}),
            "no path was published with this scenario");
  EXPECT_EQ(layer_of(layers, "trajectories").missing_reason(*first, {}), "no runs are selected");
  const ScenePtr all = all_steps(first);
  EXPECT_EQ(layer_of(layers, "shortest").missing_reason(*all, {}), "");
  EXPECT_EQ(layer_of(layers, "shortest").note(*all), "8.00 m");
  EXPECT_EQ(layer_of(layers, "distance_field").note(*all), "0 to 2.97 m");
}

TEST(SceneLayers, ReportWhyThereIsNoPath) {
  Primitives wall;
  wall.polygons.push_back({{{4, -1}, {5, -1}, {5, 7}, {4, 7}}});
  const ScenePtr scene = all_steps(prepare_scene(room(wall), {}));
  const std::vector<SceneLayer> layers = make_scene_layers();
  for (const char* path : {"shortest", "safest"})
    EXPECT_NE(layer_of(layers, path).missing_reason(*scene, {}), "") << path;
}

}  // namespace
}  // namespace slalom
