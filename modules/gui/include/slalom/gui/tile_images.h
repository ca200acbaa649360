#pragma once

#include <slalom/gui/cell_pyramid.h>

#include <array>
#include <map>
#include <memory>
#include <nanogui/nanogui.h>

namespace slalom {

/// One colour (red, green, blue, opacity) for each value of a pyramid's cells.
using ColorScale = std::array<std::array<std::uint8_t, 4>, 256>;

/// Values between 0 and 255 get colours between these two.
ColorScale blend_scale(const nanogui::Color& at_zero, const nanogui::Color& at_most);

/// The tiles of a pyramid as textures. Each is made when it is first seen; of those that are out
/// of sight the longest unseen go first, so that at most kMost stay (64 MiB).
class TileImages {
 public:
  static constexpr std::size_t kMost = 256;

  explicit TileImages(const ColorScale& colors) : colors_(colors) {}

  /// Draws what is seen. Another pyramid than last time gets textures of its own.
  void draw(NVGcontext* ctx, const std::shared_ptr<const CellPyramid>& pyramid,
            const ViewTransform& view);
  std::size_t size() const { return images_.size(); }

 private:
  struct Image {
    int handle = 0;
    long used = 0;  ///< the number of the draw() that used it last
  };
  int image_of(NVGcontext* ctx, const CellTile& tile, bool smooth);
  void draw_tile(NVGcontext* ctx, const CellTile& tile, const ViewTransform& view, bool smooth);
  void forget_unseen(NVGcontext* ctx);

  ColorScale colors_;
  std::shared_ptr<const CellPyramid> pyramid_;
  std::map<CellTile, Image> images_;
  long draws_ = 0;
};

}  // namespace slalom
