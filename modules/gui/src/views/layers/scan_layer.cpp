#include "views/layers/layers.h"
#include "views/layers/shapes.h"

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void draw_scan(const LayerContext& c, const Color& color) {
  if (!c.scan_pose || c.scene.ray_caster == nullptr) return;
  const mrpt::math::TPose2D& pose = *c.scan_pose;
  const ScanGeometry geometry = c.scene.scan_geometry();
  std::vector<float> ranges(static_cast<std::size_t>(geometry.count));
  c.scene.ray_caster->cast_scan(pose, geometry, ranges.data());
  std::vector<TPoint2D> fan = {{pose.x, pose.y}}, hits;
  for (int i = 0; i < geometry.count; ++i) {
    const double angle = pose.phi + geometry.angle(i), range = ranges[static_cast<std::size_t>(i)];
    fan.emplace_back(pose.x + range * std::cos(angle), pose.y + range * std::sin(angle));
    if (range < geometry.max_range) hits.push_back(fan.back());
  }
  shapes::fill_polygon(c.ctx, c.view, fan, faded(color, 0.25));
  shapes::dots(c.ctx, c.view, hits, color, 3);
  shapes::robot(c.ctx, c.view, c.scene.settings.robot.shape(), pose, color);
}

}  // namespace

/// The range scan at the pose under the mouse.
SceneLayer make_scan_layer() {
  SceneLayer layer{"scan", "Range scan at the mouse", palette().scan, false};
  layer.draw = [color = layer.color](const LayerContext& c) { draw_scan(c, color); };
  layer.missing_reason = [](const SceneData& scene, const auto&) -> std::string {
    if (scene.ray_caster != nullptr) return "";
    return scene.problem.empty() ? "being computed" : scene.problem;
  };
  layer.note = [](const SceneData& scene) {
    return std::to_string(scene.settings.sensor.rays) + " rays";
  };
  return layer;
}

/// The robot at the start, and the goal.
SceneLayer make_start_goal_layer() {
  SceneLayer layer{"start_goal", "Start and goal", palette().start, true};
  layer.draw = [](const LayerContext& c) {
    const Scenario& scenario = c.scene.scenario();
    const RobotModel& robot = c.scene.settings.robot;
    shapes::goal(c.ctx, c.view, scenario.goal(), robot.radius, palette().goal);
    shapes::robot(c.ctx, c.view, robot.shape(), scenario.start(), palette().start);
  };
  return layer;
}

}  // namespace slalom
