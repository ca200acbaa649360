#include <slalom/gui/scene.h>
#include <slalom/gui/scene_layers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

Scenario room(Primitives obstacles = {}) {
  return Scenario::continuous("room", {0, 0, 10, 6}, std::move(obstacles), {1, 3, 0}, {9, 3});
}

ScenePtr all_steps(ScenePtr scene) {
  const auto progress = make_silent_progress();
  while (!scene->complete()) scene = next_step(scene, *progress);
  return scene;
}

const SceneLayer& layer_of(const SceneLayers& layers, const std::string& id) {
  for (const auto& layer : layers)
    if (layer->id() == id) return *layer;
  throw std::out_of_range(id);
}

TEST(Scene, IsComputedInStepsTheQuickOnesFirst) {
  const ScenePtr first = prepare_scene(room(), {});
  EXPECT_NE(first->obstacles, nullptr);
  EXPECT_EQ(first->clearance, nullptr);
  EXPECT_EQ(first->distance_field, nullptr);
  EXPECT_EQ(first->missing_paths(), "being computed");
  const auto progress = make_silent_progress();
  const ScenePtr second = next_step(first, *progress);
  EXPECT_NE(second->clearance, nullptr);
  EXPECT_NE(second->ray_caster, nullptr);
  EXPECT_EQ(second->references, nullptr);
  EXPECT_FALSE(second->complete());
  const ScenePtr third = next_step(second, *progress);
  ASSERT_TRUE(third->complete());
  ASSERT_TRUE(third->references && third->references->shortest);
  EXPECT_NEAR(third->references->shortest->length, 8, 1e-6);
  EXPECT_EQ(next_step(third, *progress), third);
}

TEST(Scene, TellsTheLargestClearanceAndScalesThePictureToIt) {
  // 10 m x 6 m empty, cells of 5 cm: the middle is 3 m from the walls, cell centres half a cell
  // less.
  const ScenePtr scene = all_steps(prepare_scene(room(), {}));
  EXPECT_NEAR(scene->largest_clearance, 2.975, 1e-6);
  EXPECT_EQ(scene->clearance->value(0, 100, 60), 255);
  EXPECT_EQ(scene->clearance->value(0, 0, 0), std::lround(255 * 0.025 / 2.975));
}

TEST(Scene, SaysWhyThereIsNoPath) {
  Primitives wall;
  wall.polygons.push_back({{{4, -1}, {5, -1}, {5, 7}, {4, 7}}});
  const ScenePtr scene = all_steps(prepare_scene(room(wall), {}));
  EXPECT_EQ(scene->problem, "");
  ASSERT_NE(scene->references, nullptr);
  const SceneLayers layers = make_scene_layers();
  EXPECT_FALSE(layer_of(layers, "shortest").missing(*scene, {}).empty());
  EXPECT_FALSE(layer_of(layers, "safest").missing(*scene, {}).empty());
}

TEST(Scene, KeepsTheReasonWhenAStepCannotBeDone) {
  const Scenario huge = Scenario::continuous("huge", {0, 0, 1e5, 1e5}, {}, {1, 3, 0}, {9, 3});
  const ScenePtr scene = prepare_scene(huge, {});  // 4e12 cells of 5 cm
  EXPECT_TRUE(scene->complete());
  EXPECT_EQ(scene->obstacles, nullptr);
  EXPECT_NE(scene->problem, "");
  EXPECT_EQ(scene->missing_paths(), scene->problem);
}

TEST(SceneLayers, HaveIdsOfTheirOwnAndTheUsualOnesOn) {
  const SceneLayers layers = make_scene_layers();
  std::set<std::string> ids, on;
  for (const auto& layer : layers) {
    EXPECT_FALSE(layer->title().empty());
    EXPECT_TRUE(ids.insert(layer->id()).second) << layer->id();
    if (layer->on()) on.insert(layer->id());
  }
  EXPECT_EQ(ids, (std::set<std::string>{"obstacles", "distance_field", "voronoi", "published",
                                        "safest", "shortest", "scan", "trajectories", "ends"}));
  EXPECT_EQ(on, (std::set<std::string>{"obstacles", "safest", "shortest", "trajectories", "ends"}));
}

TEST(SceneLayers, TellWhatIsThereAndWhatIsNot) {
  const ScenePtr first = prepare_scene(room(), {});
  const SceneLayers layers = make_scene_layers();
  EXPECT_EQ(layer_of(layers, "distance_field").missing(*first, {}), "being computed");
  EXPECT_EQ(layer_of(layers, "published").missing(*first, {}),
            "none was published with this scenario");
  EXPECT_EQ(layer_of(layers, "trajectories").missing(*first, {}), "no runs are chosen");
  const ScenePtr all = all_steps(first);
  EXPECT_EQ(layer_of(layers, "shortest").missing(*all, {}), "");
  EXPECT_EQ(layer_of(layers, "shortest").note(*all), "8.00 m");
  EXPECT_EQ(layer_of(layers, "distance_field").note(*all), "0 to 2.97 m");
}

}  // namespace
}  // namespace slalom
