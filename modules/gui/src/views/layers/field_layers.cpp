#include "views/layers/layers.h"

#include <cstdio>

namespace slalom {
namespace {

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
    if (scene.*cells) return "";
    return scene.problem.empty() ? "being computed" : scene.problem;
  };
  layer.cells = [cells, colors](const LayerContext& c) -> std::optional<ColoredCells> {
    if (!(c.scene.*cells)) return std::nullopt;
    return ColoredCells{c.scene.*cells, colors};
  };
  return layer;
}

}  // namespace

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

}  // namespace slalom
