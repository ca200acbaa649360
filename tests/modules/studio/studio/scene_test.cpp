// SPDX-License-Identifier: BSD-3-Clause

#include <slalom/studio/scene.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

Scenario empty_room(Primitives obstacles = {}) {
  return Scenario::continuous("room", {0, 0, 10, 6}, std::move(obstacles), {1, 3, 0}, {9, 3});
}

ScenePtr all_steps(ScenePtr scene) {
  const auto progress = make_silent_progress();
  while (!scene->complete()) scene = compute_next_step(scene, *progress);
  return scene;
}

TEST(Scene, IsComputedInStepsFastOnesFirst) {
  const ScenePtr first = prepare_scene(empty_room(), {});
  EXPECT_NE(first->obstacles, nullptr);
  EXPECT_EQ(first->clearance, nullptr);
  EXPECT_EQ(first->distance_field, nullptr);
  EXPECT_EQ(first->pending_reason(), "being computed");
  const auto progress = make_silent_progress();
  const ScenePtr second = compute_next_step(first, *progress);
  EXPECT_NE(second->clearance, nullptr);
  EXPECT_NE(second->ray_caster, nullptr);
  EXPECT_EQ(second->references, nullptr);
  EXPECT_FALSE(second->complete());
  const ScenePtr third = compute_next_step(second, *progress);
  ASSERT_TRUE(third->complete());
  ASSERT_TRUE(third->references && third->references->shortest);
  EXPECT_NEAR(third->references->shortest->length, 8, 1e-6);
  EXPECT_EQ(compute_next_step(third, *progress), third);
}

TEST(Scene, ScalesClearanceToItsMaximum) {
  // 10 m x 6 m empty, cells of 5 cm: the center is 3 m from the walls, cell centers half a cell
  // less.
  const ScenePtr scene = all_steps(prepare_scene(empty_room(), {}));
  EXPECT_NEAR(scene->max_clearance, 2.975, 1e-6);
  EXPECT_EQ(scene->clearance->value(0, 100, 60), 255);
  EXPECT_EQ(scene->clearance->value(0, 0, 0), std::lround(255 * 0.025 / 2.975));
}

TEST(Scene, ReportsWhyThereIsNoPath) {
  Primitives wall;
  wall.polygons.push_back({{{4, -1}, {5, -1}, {5, 7}, {4, 7}}});
  const ScenePtr scene = all_steps(prepare_scene(empty_room(wall), {}));
  EXPECT_EQ(scene->problem, "");
  ASSERT_NE(scene->references, nullptr);
  EXPECT_FALSE(scene->references->shortest_reason.empty());
  EXPECT_FALSE(scene->references->safest_reason.empty());
}

TEST(Scene, KeepsTheReasonOfAFailedStep) {
  const Scenario huge = Scenario::continuous("huge", {0, 0, 1e5, 1e5}, {}, {1, 3, 0}, {9, 3});
  const ScenePtr scene = prepare_scene(huge, {});  // 4e12 cells of 5 cm
  EXPECT_TRUE(scene->complete());
  EXPECT_EQ(scene->obstacles, nullptr);
  EXPECT_NE(scene->problem, "");
  EXPECT_EQ(scene->pending_reason(), scene->problem);
}

}  // namespace
}  // namespace slalom
