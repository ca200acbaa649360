#include "layers.h"
#include "shapes.h"

#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/tile_images.h>

#include <algorithm>
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

/// The floor and what stands on it: primitives as they are, cells, or points on the cells that
/// they occupy. Of more shapes than can be drawn in time, the cells that they occupy are shown.
class ObstaclesLayer : public SceneLayer {
 public:
  ObstaclesLayer()
      : SceneLayer("obstacles", "Obstacles", palette().obstacle, true),
        cells_(blend_scale(palette().floor, palette().obstacle)),
        cells_of_points_(blend_scale(palette().floor, palette().point_cell)) {}

  void draw(const LayerContext& c) override {
    switch (c.scene.scenario().representation()) {
      case Representation::Continuous:
        return draw_primitives(c);
      case Representation::Grid:
        return cells_.draw(c.ctx, c.scene.obstacles, c.view);
      case Representation::Points:
        return draw_points(c);
    }
  }

 private:
  static constexpr std::size_t kMostPrimitives = 600, kMostPoints = 3000;

  void draw_primitives(const LayerContext& c) {
    const Primitives& all = c.scene.scenario().primitives();
    const Bounds seen = c.view.visible();
    const auto is_seen = [&seen](const auto& shape) { return overlap(bounds_of(shape), seen); };
    const auto count = std::count_if(all.discs.begin(), all.discs.end(), is_seen) +
                       std::count_if(all.polygons.begin(), all.polygons.end(), is_seen);
    if (c.scene.obstacles && static_cast<std::size_t>(count) > kMostPrimitives)
      return cells_.draw(c.ctx, c.scene.obstacles, c.view);
    draw_floor(c);
    for (const Disc& disc : all.discs)
      if (is_seen(disc)) shapes::fill_disc(c.ctx, c.view, disc, color(), 1);
    for (const Polygon& polygon : all.polygons)
      if (is_seen(polygon)) shapes::fill_polygon(c.ctx, c.view, polygon.vertices, color());
  }

  void draw_points(const LayerContext& c) {
    if (c.scene.obstacles)
      cells_of_points_.draw(c.ctx, c.scene.obstacles, c.view);
    else
      draw_floor(c);
    const auto& map = *c.scene.scenario().point_map();
    const auto& xs = map.getPointsBufferRef_x();
    const auto& ys = map.getPointsBufferRef_y();
    const Bounds seen = c.view.visible();
    std::vector<TPoint2D> points;
    for (std::size_t i = 0; i < xs.size() && points.size() <= kMostPoints; ++i)
      if (seen.contains({xs[i], ys[i]})) points.push_back(c.view.to_screen({xs[i], ys[i]}));
    if (points.size() > kMostPoints && c.scene.obstacles) return;
    nvgBeginPath(c.ctx);
    for (const TPoint2D& p : points)
      nvgRect(c.ctx, static_cast<float>(p.x - 1), static_cast<float>(p.y - 1), 2, 2);
    nvgFillColor(c.ctx, color());
    nvgFill(c.ctx);
  }

  static void draw_floor(const LayerContext& c) {
    const Bounds& bounds = c.scene.scenario().bounds();
    const TPoint2D low = c.view.to_screen({bounds.x_min, bounds.y_min});
    const TPoint2D high = c.view.to_screen({bounds.x_max, bounds.y_max});
    draw::fill(c.ctx, {low.x, high.y, high.x - low.x, low.y - high.y}, palette().floor);
  }

  TileImages cells_, cells_of_points_;
};

}  // namespace

std::unique_ptr<SceneLayer> make_obstacles_layer() {
  return std::make_unique<ObstaclesLayer>();
}

}  // namespace slalom
