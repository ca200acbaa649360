#include "views/layers/layers.h"
#include "views/layers/shapes.h"

#include <slalom/studio/palette.h>

#include <algorithm>

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

}  // namespace

/// The obstacles: primitives, cells, or points on the cells that they occupy. If there are too many
/// shapes to be drawn in time, only the cells that they occupy are drawn.
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
  };
  return layer;
}

}  // namespace slalom
