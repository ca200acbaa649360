#pragma once

#include <slalom/gui/cell_pyramid.h>
#include <slalom/gui/element.h>

#include <array>
#include <map>
#include <memory>
#include <nanogui/nanogui.h>
#include <utility>
#include <vector>

namespace slalom {

/// One colour (red, green, blue, opacity) for each value of a pyramid's cells.
using ColorScale = std::array<std::array<std::uint8_t, 4>, 256>;
using ColorScalePtr = std::shared_ptr<const ColorScale>;

/// Values between 0 and 255 get colours between these two.
ColorScalePtr blend_scale(const nanogui::Color& at_zero, const nanogui::Color& at_most);

/// Cells in colours.
struct CellPicture {
  std::shared_ptr<const CellPyramid> pyramid;
  ColorScalePtr colors;
  bool operator==(const CellPicture& o) const { return pyramid == o.pyramid && colors == o.colors; }
};

/// The pixels (RGBA, the lowest row first) of one tile of pictures of the same grid that lie upon
/// each other, the last on top, over `floor`.
std::vector<std::uint8_t> compose_tile(const std::vector<CellPicture>& pictures,
                                       const CellTile& tile, const nanogui::Color& floor);

/// Where a view lies in the window: pixels of the framebuffer are `ratio` times as many.
struct FramePlace {
  double left = 0, top = 0;  ///< of the view in the window (pixels)
  double height = 0;         ///< of the window
  double ratio = 1;
};

/// Pictures of one grid as textures in tiles, all of them in one texture. A tile is made when it is
/// first seen; of those that are out of sight the longest unseen go first, so that at most kMost
/// stay (32 MiB).
///
/// They are copied to the window by OpenGL itself, as software renderers take ten times as long for
/// NanoVG's paints. So they lie below all that NanoVG draws in the same frame, which it keeps until
/// the frame's end: nothing may fill the view behind them.
class TileImages {
 public:
  static constexpr std::size_t kMost = 128;

  /// Draws what is seen of the pictures, all of the same grid, within `clip`; outside the floor
  /// (both pixels of the view) one colour. Other pictures than last time get textures of their own.
  void draw(const std::vector<CellPicture>& pictures, const nanogui::Color& floor_color,
            const nanogui::Color& outside, const ScreenRect& floor, const ScreenRect& clip,
            const ViewTransform& view, const FramePlace& place);

 private:
  struct Image {
    unsigned texture = 0;
    long used = 0;  ///< the number of the draw() that used it last
  };
  unsigned texture_of(const CellTile& tile, const nanogui::Color& floor);
  void draw_tile(const CellTile& tile, const nanogui::Color& floor, const ViewTransform& view,
                 const FramePlace& place);
  void forget_all();
  void forget_unseen();

  std::vector<CellPicture> pictures_;
  std::map<CellTile, Image> images_;
  long draws_ = 0;
  unsigned source_ = 0;  ///< framebuffer from which is copied
};

/// The cells of a tile that are seen, and the pixels of the view on which they come to lie: whole
/// numbers, so that neighbours share their borders.
struct TileCut {
  int cell_left = 0, cell_low = 0, cell_right = 0, cell_high = 0;  ///< in the tile; ends excluded
  int left = 0, top = 0, right = 0, bottom = 0;                    ///< pixels times `ratio`
};
TileCut cut_tile(const CellPyramid& pyramid, const CellTile& tile, const ViewTransform& view,
                 double ratio);

}  // namespace slalom
