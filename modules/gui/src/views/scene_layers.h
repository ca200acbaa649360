#pragma once

#include "views/tile_images.h"

#include <slalom/studio/results_overlay.h>
#include <slalom/studio/scene.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What layers need for drawing.
struct LayerContext {
  NVGcontext* ctx = nullptr;
  const SceneData& scene;
  const ViewTransform& view;
  const std::vector<OverlayTrajectory>& trajectories;
  std::optional<mrpt::math::TPose2D> scan_pose;  ///< pose of the range sensor
};

/// One layer of the scenario view, which can be switched on or off.
struct SceneLayer {
  std::string id, title;
  Color color;  ///< in the legend
  bool on;
  /// Draws in screen coordinates of the view, above the cells of all layers.
  std::function<void(const LayerContext&)> draw = [](const LayerContext&) {};
  /// Why there is nothing to draw; empty otherwise.
  std::function<std::string(const SceneData&, const std::vector<OverlayTrajectory>&)>
      missing_reason = [](const SceneData&, const auto&) { return ""; };
  /// A short note for the legend, with units; may be empty.
  std::function<std::string(const SceneData&)> note = [](const SceneData&) { return ""; };
  /// The cells of the layer, if any. The view draws those of all layers at once, above the
  /// workspace and below everything else, before draw().
  std::function<std::optional<ColoredCells>(const LayerContext&)> cells = [](const LayerContext&) {
    return std::nullopt;
  };
};

/// All layers in drawing order: obstacles, distance_field, voronoi, published, safest, shortest,
/// scan, trajectories, start_goal.
std::vector<SceneLayer> make_scene_layers();

}  // namespace slalom
