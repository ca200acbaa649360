// SPDX-License-Identifier: BSD-3-Clause
#include "views/scene_layers.h"
#include "views/shapes.h"
#include "widgets/drawing.h"

#include <slalom/core/math.h>
#include <slalom/core/pose.h>
#include <slalom/core/text.h>
#include <slalom/simulation/mover_scan.h>
#include <slalom/studio/palette.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nanovg.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

bool overlap(const Bounds& a, const Bounds& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

Bounds bounds_of(const Disc& disc) {
  const auto& [c, r] = disc;
  return {c.x - r, c.y - r, c.x + r, c.y + r};
}

Bounds bounds_of(const Polygon& polygon) {
  Bounds box{polygon.vertices[0].x, polygon.vertices[0].y, polygon.vertices[0].x,
             polygon.vertices[0].y};
  for (const TPoint2D& p : polygon.vertices)
    box = {std::min(box.x_min, p.x), std::min(box.y_min, p.y), std::max(box.x_max, p.x),
           std::max(box.y_max, p.y)};
  return box;
}

/// The visible shapes of a scenario, unless they are too many to be drawn.
class VisibleShapes {
 public:
  void find(const LayerContext& c) {
    discs_.clear();
    polygons_.clear();
    points_.clear();
    too_many_ = false;
    const Bounds visible = c.view.visible();
    if (c.scene.scenario().representation() == Representation::Continuous)
      find_primitives(c.scene.scenario().primitives(), visible);
    if (c.scene.scenario().representation() == Representation::Points)
      find_points(*c.scene.scenario().point_map(), visible);
  }

  bool too_many() const { return too_many_; }
  void draw(const LayerContext& c, const Color& color) const {
    for (const Disc* disc : discs_) shapes::fill_disc(c.ctx, c.view, *disc, color, 1);
    for (const Polygon* polygon : polygons_)
      shapes::fill_polygon(c.ctx, c.view, polygon->vertices, color);
    shapes::dots(c.ctx, c.view, points_, color, 2);
  }

 private:
  static constexpr std::size_t kMaxPrimitives = 600, kMaxPoints = 3000;

  void find_primitives(const Primitives& all, const Bounds& visible) {
    for (const Disc& disc : all.discs)
      if (overlap(bounds_of(disc), visible)) discs_.push_back(&disc);
    for (const Polygon& polygon : all.polygons)
      if (overlap(bounds_of(polygon), visible)) polygons_.push_back(&polygon);
    too_many_ = discs_.size() + polygons_.size() > kMaxPrimitives;
  }

  void find_points(const mrpt::maps::CSimplePointsMap& map, const Bounds& visible) {
    const auto& xs = map.getPointsBufferRef_x();
    const auto& ys = map.getPointsBufferRef_y();
    for (std::size_t i = 0; i < xs.size() && !too_many_; ++i) {
      if (visible.contains({xs[i], ys[i]})) points_.emplace_back(xs[i], ys[i]);
      too_many_ = points_.size() > kMaxPoints;
    }
  }

  std::vector<const Disc*> discs_;
  std::vector<const Polygon*> polygons_;
  std::vector<TPoint2D> points_;
  bool too_many_ = false;
};

using CellsOfScene = std::shared_ptr<const CellPyramid> SceneData::*;

/// Transparent at clearance 0, so that the obstacles are visible.
ColorScalePtr clearance_scale() {
  auto scale = std::make_shared<ColorScale>();
  for (std::size_t value = 1; value < scale->size(); ++value) {
    const Color color = heat_color(static_cast<double>(value) / 255);
    (*scale)[value] = {color.R, color.G, color.B, 255};
  }
  return scale;
}

SceneLayer cell_layer(SceneLayer layer, CellsOfScene cells, const ColorScalePtr& colors) {
  layer.missing_reason = [cells](const SceneData& scene, const auto&) -> std::string {
    return scene.*cells ? "" : scene.pending_reason();
  };
  layer.cells = [cells, colors](const LayerContext& c) -> std::optional<ColoredCells> {
    if (!(c.scene.*cells)) return std::nullopt;
    return ColoredCells{c.scene.*cells, colors};
  };
  return layer;
}

using PathOf = const Path* (*)(const SceneData&);

const Path* shortest_of(const SceneData& scene) {
  const auto& references = scene.references;
  return references && references->shortest ? &references->shortest->path : nullptr;
}

const Path* safest_of(const SceneData& scene) {
  const auto& references = scene.references;
  return references && references->safest ? &references->safest->path : nullptr;
}

const Path* published_of(const SceneData& scene) {
  const PublishedPathPtr& published = scene.scenario().published_path();
  return published ? &published->points : nullptr;
}

std::string meters(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

SceneLayer path_layer(SceneLayer layer, PathOf path_of, float width) {
  layer.draw = [path_of, width, color = layer.color](const LayerContext& c) {
    if (const Path* path = path_of(c.scene)) shapes::polyline(c.ctx, c.view, *path, color, width);
  };
  return layer;
}

void draw_laser(const LayerContext& c, const LaserModel& laser, const Color& color) {
  const TPoint2D at = compose(*c.scan_pose, {laser.x, laser.y});
  const mrpt::math::TPose2D pose(at.x, at.y, c.scan_pose->phi + laser.yaw);
  const ScanGeometry geometry = {laser.rays, laser.aperture(), laser.max_range};
  std::vector<float> ranges(static_cast<std::size_t>(geometry.count));
  c.scene.ray_caster->cast_scan(pose, geometry, ranges.data());
  for (const Movers* movers : {&c.scene.scenario().movers(), &c.people})
    MoverScan(*movers, geometry).add_to(pose, c.time, ranges.data());
  std::vector<TPoint2D> fan = {{pose.x, pose.y}}, hits;
  for (int i = 0; i < geometry.count; ++i) {
    const double angle = pose.phi + geometry.angle(i), range = ranges[static_cast<std::size_t>(i)];
    fan.emplace_back(pose.x + range * math::cos(angle), pose.y + range * math::sin(angle));
    if (range < geometry.max_range) hits.push_back(fan.back());
  }
  shapes::fill_polygon(c.ctx, c.view, fan, faded(color, 0.25));
  shapes::dots(c.ctx, c.view, hits, color, 3);
}

void draw_scan(const LayerContext& c, const Color& color) {
  if (!c.scan_pose || c.scene.ray_caster == nullptr) return;
  for (const LaserModel& laser : c.scene.settings.sensor.all_lasers()) draw_laser(c, laser, color);
  shapes::robot(c.ctx, c.view, c.scene.settings.robot.shape(), *c.scan_pose, color);
}

/// Draws, when runs are colored by values, the line of the method below and wider, so that methods
/// are told apart.
void draw_run_line(const LayerContext& c, const OverlayTrajectory& run, double max_value) {
  const Path whole = run.trajectory->path();
  const TPoint2D end = c.view.to_screen(whole.back());
  const std::vector<double>* values = c.overlay.colored_values(run.run);
  Path path = whole;
  path.resize(run.sample + 1);
  path.emplace_back(run.pose.x, run.pose.y);
  shapes::polyline(c.ctx, c.view, whole, run.color, values ? 5 : 1.5F);
  shapes::polyline(c.ctx, c.view, path, run.color, values ? 9 : 4);
  if (values)
    for (const ColoredPart& part : colored_parts(*values, max_value))
      shapes::polyline(c.ctx, c.view,
                       Path(whole.begin() + static_cast<std::ptrdiff_t>(part.begin),
                            whole.begin() + static_cast<std::ptrdiff_t>(part.end) + 1),
                       part.color, 4);
  constexpr float kHalf = 5;
  nvgBeginPath(c.ctx);
  nvgRect(c.ctx, static_cast<float>(end.x) - kHalf, static_cast<float>(end.y) - kHalf, 2 * kHalf,
          2 * kHalf);
  draw::fill_path(c.ctx, outcome_color(run.outcome));
  draw::stroke_path(c.ctx, run.color, 2);
}

void draw_run_robot(const LayerContext& c, const OverlayTrajectory& run) {
  if (run.scan && run.scan->size() > 1) {
    std::vector<TPoint2D> fan = {{run.pose.x, run.pose.y}};
    fan.insert(fan.end(), run.scan->begin(), run.scan->end());
    shapes::fill_polygon(c.ctx, c.view, fan, faded(run.color, 0.15));
  }
  const Footprint footprint = run.footprint.value_or(c.scene.settings.robot.shape());
  shapes::robot(c.ctx, c.view, footprint, run.pose, run.color);
}

/// The obstacles: primitives, cells, or points on the cells that they occupy. If there are too many
/// shapes to be drawn in time, only the cells that they occupy are drawn. And movers and people.
SceneLayer make_obstacles_layer() {
  SceneLayer layer{"obstacles", "Obstacles", palette().obstacle, true};
  const auto visible = std::make_shared<VisibleShapes>();  // found by cells(), used by draw()
  layer.cells = [visible, full = make_color_scale(palette().free_space, palette().obstacle),
                 faint = make_color_scale(palette().free_space, palette().point_cell)](
                    const LayerContext& c) -> std::optional<ColoredCells> {
    visible->find(c);
    if (!c.scene.obstacles) return std::nullopt;
    const Representation kind = c.scene.scenario().representation();
    if (kind == Representation::Continuous && !visible->too_many()) return std::nullopt;
    return ColoredCells{c.scene.obstacles, kind == Representation::Points ? faint : full};
  };
  layer.draw = [visible, color = layer.color](const LayerContext& c) {
    if (!visible->too_many() || !c.scene.obstacles) visible->draw(c, color);
    for (const Mover& mover : c.scene.scenario().movers())
      shapes::mover(c.ctx, c.view, mover, c.time, palette().mover);
    const People& people = c.scene.scenario().people();
    for (std::size_t i = 0; i < people.size(); ++i)
      shapes::person(c.ctx, c.view, people[i], c.people[i], c.time);
  };
  layer.note = [](const SceneData& scene) -> std::string {
    const std::size_t movers = scene.scenario().movers().size(),
                      people = scene.scenario().people().size();
    std::string text = movers == 0 ? "" : count_text(movers, "moving obstacle");
    if (people > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(people) +
              (people == 1 ? " person" : " people");
    return text;
  };
  return layer;
}

SceneLayer make_distance_field_layer() {
  SceneLayer layer = cell_layer({"distance_field", "Distance field", heat_color(0.75), false},
                                &SceneData::clearance, clearance_scale());
  layer.note = [](const SceneData& scene) -> std::string {
    char text[48];
    std::snprintf(text, sizeof text, "0 to %.2f m", scene.max_clearance);
    return scene.clearance ? text : "";
  };
  return layer;
}

SceneLayer make_voronoi_layer() {
  const Color& color = palette().voronoi;
  return cell_layer({"voronoi", "Voronoi diagram", color, false}, &SceneData::voronoi,
                    make_color_scale(faded(color, 0), color));
}

SceneLayer make_shortest_path_layer() {
  SceneLayer layer =
      path_layer({"shortest", "Shortest path", palette().shortest, true}, shortest_of, 2.5F);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return scene.references ? scene.references->shortest_reason : scene.pending_reason();
  };
  layer.note = [](const SceneData& scene) {
    return shortest_of(scene) ? meters(scene.references->shortest->length) : "";
  };
  return layer;
}

SceneLayer make_safest_path_layer() {
  SceneLayer layer = path_layer({"safest", "Safest path", palette().safest, true}, safest_of, 2.5F);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return scene.references ? scene.references->safest_reason : scene.pending_reason();
  };
  layer.note = [](const SceneData& scene) {
    const Path* path = safest_of(scene);
    return path ? meters(length(*path)) : "";
  };
  return layer;
}

SceneLayer make_published_path_layer() {
  SceneLayer layer =
      path_layer({"published", "Published path", palette().published, false}, published_of, 2);
  layer.missing_reason = [](const SceneData& scene, const auto&) {
    return published_of(scene) ? "" : "no path was published with this scenario";
  };
  return layer;
}

/// The range scan at the pose under the mouse.
SceneLayer make_scan_layer() {
  SceneLayer layer{"scan", "Range scan at the mouse", palette().scan, false};
  layer.draw = [color = layer.color](const LayerContext& c) { draw_scan(c, color); };
  layer.missing_reason = [](const SceneData& scene, const auto&) -> std::string {
    return scene.ray_caster != nullptr ? "" : scene.pending_reason();
  };
  layer.note = [](const SceneData& scene) {
    int rays = 0;
    for (const LaserModel& laser : scene.settings.sensor.all_lasers()) rays += laser.rays;
    return std::to_string(rays) + " rays";
  };
  return layer;
}

/// The robot at the start, and the goal.
SceneLayer make_start_goal_layer() {
  SceneLayer layer{"start_goal", "Start and goal", palette().start, true};
  layer.draw = [](const LayerContext& c) {
    const Scenario& scenario = c.scene.scenario();
    const RobotModel& robot = c.scene.settings.robot;
    shapes::goal(c.ctx, c.view, scenario.goal(), scenario.goal_heading(), robot.radius,
                 palette().goal);
    shapes::robot(c.ctx, c.view, robot.shape(), scenario.start(), palette().start);
  };
  return layer;
}

/// The runs in the colors of their methods or values, bold up to the time of the replay, each end
/// marked in the color of its outcome, and the robots at the time of the replay.
SceneLayer make_trajectories_layer() {
  SceneLayer layer{"trajectories", "Trajectories", method_line_color(0), true};
  layer.draw = [](const LayerContext& c) {
    const double max_value = c.overlay.max_colored_value();
    for (const OverlayTrajectory& run : c.trajectories) draw_run_line(c, run, max_value);
    for (const OverlayTrajectory& run : c.trajectories) draw_run_robot(c, run);
  };
  layer.missing_reason = [](const SceneData&, const std::vector<OverlayTrajectory>& runs) {
    return runs.empty() ? "no runs are selected" : "";
  };
  return layer;
}

}  // namespace

std::vector<SceneLayer> make_scene_layers() {
  return {make_obstacles_layer(),      make_distance_field_layer(), make_voronoi_layer(),
          make_published_path_layer(), make_safest_path_layer(),    make_shortest_path_layer(),
          make_scan_layer(),           make_trajectories_layer(),   make_start_goal_layer()};
}

}  // namespace slalom
