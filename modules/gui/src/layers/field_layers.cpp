#include "layers.h"

#include <slalom/gui/palette.h>

#include <cmath>
#include <cstdio>

namespace slalom {
namespace {

/// Where there is no clearance the obstacles are seen through it.
ColorScalePtr clearance_scale() {
  auto scale = std::make_shared<ColorScale>();
  for (std::size_t value = 0; value < scale->size(); ++value) {
    const nanogui::Color color = heat_color(static_cast<double>(value) / 255);
    for (int c = 0; c < 3; ++c)
      (*scale)[value][static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(255 * color[c]));
    (*scale)[value][3] = value == 0 ? 0 : 255;
  }
  return scale;
}

std::string missing_step(const SceneData& scene) {
  return scene.problem.empty() ? "being computed" : scene.problem;
}

class DistanceFieldLayer : public SceneLayer {
 public:
  DistanceFieldLayer()
      : SceneLayer("distance_field", "Distance field", heat_color(0.75), false),
        colors_(clearance_scale()) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    return scene.clearance ? "" : missing_step(scene);
  }
  std::string note(const SceneData& scene) const override {
    char text[48];
    std::snprintf(text, sizeof text, "0 to %.2f m", scene.largest_clearance);
    return scene.clearance ? text : "";
  }
  std::optional<CellPicture> cells(const LayerContext& c) override {
    if (!c.scene.clearance) return std::nullopt;
    return CellPicture{c.scene.clearance, colors_};
  }

 private:
  ColorScalePtr colors_;
};

nanogui::Color transparent(nanogui::Color color) {
  color.w() = 0;
  return color;
}

class VoronoiLayer : public SceneLayer {
 public:
  VoronoiLayer()
      : SceneLayer("voronoi", "Voronoi diagram", palette().voronoi, false),
        colors_(blend_scale(transparent(palette().voronoi), palette().voronoi)) {}

  std::string missing(const SceneData& scene,
                      const std::vector<OverlayTrajectory>&) const override {
    return scene.voronoi ? "" : missing_step(scene);
  }
  std::optional<CellPicture> cells(const LayerContext& c) override {
    if (!c.scene.voronoi) return std::nullopt;
    return CellPicture{c.scene.voronoi, colors_};
  }

 private:
  ColorScalePtr colors_;
};

}  // namespace

std::unique_ptr<SceneLayer> make_distance_field_layer() {
  return std::make_unique<DistanceFieldLayer>();
}
std::unique_ptr<SceneLayer> make_voronoi_layer() {
  return std::make_unique<VoronoiLayer>();
}

}  // namespace slalom
