#include "layers.h"
#include "shapes.h"

#include <slalom/gui/palette.h>

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

/// What stands on the floor: primitives as they are, cells, or points on the cells that they
/// occupy. Of more shapes than can be drawn in time only the cells that they occupy are shown.
class ObstaclesLayer : public SceneLayer {
 public:
  ObstaclesLayer()
      : SceneLayer("obstacles", "Obstacles", palette().obstacle, true),
        full_(blend_scale(palette().floor, palette().obstacle)),
        faint_(blend_scale(palette().floor, palette().point_cell)) {}

  std::optional<CellPicture> cells(const LayerContext& c) override {
    find_seen(c);
    if (!c.scene.obstacles) return std::nullopt;
    const Representation kind = c.scene.scenario().representation();
    if (kind == Representation::Continuous && !too_many_) return std::nullopt;
    return CellPicture{c.scene.obstacles, kind == Representation::Points ? faint_ : full_};
  }

  void draw(const LayerContext& c) override {
    if (too_many_ && c.scene.obstacles) return;
    for (const Disc* disc : discs_) shapes::fill_disc(c.ctx, c.view, *disc, color(), 1);
    for (const Polygon* polygon : polygons_)
      shapes::fill_polygon(c.ctx, c.view, polygon->vertices, color());
    shapes::dots(c.ctx, c.view, points_, color(), 2);
  }

 private:
  static constexpr std::size_t kMostPrimitives = 600, kMostPoints = 3000;

  /// The shapes that are seen, unless they are too many to be drawn.
  void find_seen(const LayerContext& c) {
    discs_.clear();
    polygons_.clear();
    points_.clear();
    too_many_ = false;
    const Bounds seen = c.view.visible();
    if (c.scene.scenario().representation() == Representation::Continuous)
      find_primitives(c.scene.scenario().primitives(), seen);
    if (c.scene.scenario().representation() == Representation::Points)
      find_points(*c.scene.scenario().point_map(), seen);
  }

  void find_primitives(const Primitives& all, const Bounds& seen) {
    for (const Disc& disc : all.discs)
      if (overlap(bounds_of(disc), seen)) discs_.push_back(&disc);
    for (const Polygon& polygon : all.polygons)
      if (overlap(bounds_of(polygon), seen)) polygons_.push_back(&polygon);
    too_many_ = discs_.size() + polygons_.size() > kMostPrimitives;
  }

  void find_points(const mrpt::maps::CSimplePointsMap& map, const Bounds& seen) {
    const auto& xs = map.getPointsBufferRef_x();
    const auto& ys = map.getPointsBufferRef_y();
    for (std::size_t i = 0; i < xs.size() && !too_many_; ++i) {
      if (seen.contains({xs[i], ys[i]})) points_.emplace_back(xs[i], ys[i]);
      too_many_ = points_.size() > kMostPoints;
    }
  }

  ColorScalePtr full_, faint_;
  /// Of the scene that is being drawn.
  std::vector<const Disc*> discs_;
  std::vector<const Polygon*> polygons_;
  std::vector<TPoint2D> points_;
  bool too_many_ = false;
};

}  // namespace

std::unique_ptr<SceneLayer> make_obstacles_layer() {
  return std::make_unique<ObstaclesLayer>();
}

}  // namespace slalom
