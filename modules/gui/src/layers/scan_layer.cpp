#include "layers.h"
#include "shapes.h"

#include <slalom/gui/palette.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// What the range sensor sees from the pose under the mouse.
class ScanLayer : public SceneLayer {
 public:
  ScanLayer() : SceneLayer("scan", "Range scan at the mouse", palette().scan, false) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    if (scene.ray_caster != nullptr) return "";
    return scene.problem.empty() ? "being computed" : scene.problem;
  }
  std::string note(const SceneData& scene) const override {
    return std::to_string(scene.settings.sensor.rays) + " rays";
  }

  void draw(const LayerContext& c) override {
    if (!c.scan_pose || c.scene.ray_caster == nullptr) return;
    const mrpt::math::TPose2D& pose = *c.scan_pose;
    const ScanGeometry geometry = c.scene.scan_geometry();
    ranges_.resize(static_cast<std::size_t>(geometry.count));
    c.scene.ray_caster->cast_scan(pose, geometry, ranges_.data());
    std::vector<TPoint2D> fan = {{pose.x, pose.y}}, hits;
    for (int i = 0; i < geometry.count; ++i) {
      const double angle = pose.phi + geometry.angle(i),
                   range = ranges_[static_cast<std::size_t>(i)];
      fan.emplace_back(pose.x + range * std::cos(angle), pose.y + range * std::sin(angle));
      if (range < geometry.max_range) hits.push_back(fan.back());
    }
    shapes::fill_polygon(c.ctx, c.view, fan, shapes::faded(color(), 0.25F));
    shapes::dots(c.ctx, c.view, hits, color(), 3);
    shapes::robot(c.ctx, c.view, c.scene.settings.robot.shape(), pose, color());
  }

 private:
  std::vector<float> ranges_;
};

}  // namespace

std::unique_ptr<SceneLayer> make_scan_layer() {
  return std::make_unique<ScanLayer>();
}

}  // namespace slalom
