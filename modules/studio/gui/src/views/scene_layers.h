// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "views/view_layout.h"
#include "widgets/element.h"

#include <slalom/studio/palette.h>
#include <slalom/studio/results_overlay.h>
#include <slalom/studio/scene.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// A color (RGBA) for each cell value of a pyramid.
using ColorScale = std::array<std::array<std::uint8_t, 4>, 256>;
using ColorScalePtr = std::shared_ptr<const ColorScale>;

/// Interpolates linearly between two colors, for the values 0 and 255.
ColorScalePtr make_color_scale(const Color& at_min, const Color& at_max);

/// Cells with their colors.
struct ColoredCells {
  std::shared_ptr<const CellPyramid> pyramid;
  ColorScalePtr colors;
  bool operator==(const ColoredCells& o) const {
    return pyramid == o.pyramid && colors == o.colors;
  }
};

/// The pixels (RGBA, bottom row first) of a tile: layers of the same grid over `background`, the
/// last on top.
std::vector<std::uint8_t> compose_tile(const std::vector<ColoredCells>& layers,
                                       const CellTile& tile, const Color& background);

/// The position of a view in the window.
struct Viewport {
  double left = 0, top = 0;  ///< of the view in the window (pixels)
  double height = 0;         ///< of the window
  double ratio = 1;          ///< framebuffer pixels per pixel
};

/// Layers of one grid as tiles, with one texture per tile for all layers. A tile is created when it
/// first becomes visible. The least recently visible tiles are evicted, so that at most kMaxImages
/// remain (32 MiB).
///
/// The tiles are copied to the framebuffer by OpenGL itself, because software renderers take ten
/// times as long for NanoVG paints. NanoVG draws at the end of the frame, therefore on top of them:
/// nothing may fill the background of the view with NanoVG.
class TileImages {
 public:
  static constexpr std::size_t kMaxImages = 128;

  /// Draws the visible part of the layers, all of the same grid, within `clip`; one color outside
  /// `extent` (both pixels of the view). Other layers than last time get new textures.
  void draw(const std::vector<ColoredCells>& layers, const Color& background, const Color& outside,
            const ScreenRect& extent, const ScreenRect& clip, const ViewTransform& view,
            const Viewport& viewport);

 private:
  struct Image {
    unsigned texture = 0;
    long used = 0;  ///< number of the last draw() that used it
  };
  unsigned texture_of(const CellTile& tile, const Color& background);
  void draw_tile(const CellTile& tile, const Color& background, const ViewTransform& view,
                 const Viewport& viewport);
  void delete_textures();
  void evict_textures();

  std::vector<ColoredCells> layers_;
  std::map<CellTile, Image> images_;
  long draws_ = 0;
  unsigned source_ = 0;  ///< framebuffer to copy from
};

/// The visible cells of a tile and their pixels in the view. Integers, so that adjacent tiles share
/// their borders.
struct TileClip {
  int cell_left = 0, cell_low = 0, cell_right = 0, cell_high = 0;  ///< in the tile; half-open
  int left = 0, top = 0, right = 0, bottom = 0;                    ///< pixels times `ratio`
};
TileClip clip_tile(const CellPyramid& pyramid, const CellTile& tile, const ViewTransform& view,
                   double ratio);

/// Context in which layers are drawn.
struct LayerContext {
  NVGcontext* ctx = nullptr;
  const SceneData& scene;
  const ViewTransform& view;
  const std::vector<OverlayTrajectory>& trajectories;
  const ResultsOverlay& overlay;                 ///< of the trajectories
  Movers people;                                 ///< ResultsOverlay::people_in()
  std::optional<mrpt::math::TPose2D> scan_pose;  ///< pose of the range sensor
  double time = 0;                               ///< s of a run, at which movers are drawn
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
