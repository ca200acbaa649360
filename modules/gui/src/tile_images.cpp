#include <slalom/gui/tile_images.h>

#include <algorithm>
#include <cmath>
#include <nanovg.h>
#include <vector>

namespace slalom {

ColorScale blend_scale(const nanogui::Color& at_zero, const nanogui::Color& at_most) {
  ColorScale scale;
  for (int value = 0; value < 256; ++value)
    for (int c = 0; c < 4; ++c) {
      const float part = static_cast<float>(value) / 255;
      const float mixed = at_zero[c] * (1 - part) + at_most[c] * part;
      scale[static_cast<std::size_t>(value)][static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(255 * std::clamp(mixed, 0.0F, 1.0F)));
    }
  return scale;
}

void TileImages::draw(NVGcontext* ctx, const std::shared_ptr<const CellPyramid>& pyramid,
                      const ViewTransform& view) {
  ++draws_;
  if (pyramid != pyramid_) {
    for (const auto& [tile, image] : images_) nvgDeleteImage(ctx, image.handle);
    images_.clear();
    pyramid_ = pyramid;
  }
  if (!pyramid_) return;
  const int level = pyramid_->level_for(view.pixels_per_metre());
  nvgShapeAntiAlias(ctx, 0);  // soft borders would show as lines between tiles
  for (const CellTile& tile : pyramid_->tiles_in(level, view.visible()))
    draw_tile(ctx, tile, view, level > 0);
  nvgShapeAntiAlias(ctx, 1);
  forget_unseen(ctx);
}

/// Borders lie on whole pixels, so that neighbours share them.
void TileImages::draw_tile(NVGcontext* ctx, const CellTile& tile, const ViewTransform& view,
                           bool smooth) {
  const Bounds bounds = pyramid_->bounds_of(tile);
  const auto low = view.to_screen({bounds.x_min, bounds.y_min});
  const auto high = view.to_screen({bounds.x_max, bounds.y_max});
  const auto left = static_cast<float>(std::round(low.x));
  const auto top = static_cast<float>(std::round(high.y));
  const float width = static_cast<float>(std::round(high.x)) - left;
  const float height = static_cast<float>(std::round(low.y)) - top;
  if (width <= 0 || height <= 0) return;
  nvgBeginPath(ctx);
  nvgRect(ctx, left, top, width, height);
  nvgFillPaint(ctx,
               nvgImagePattern(ctx, left, top, width, height, 0, image_of(ctx, tile, smooth), 1));
  nvgFill(ctx);
}

int TileImages::image_of(NVGcontext* ctx, const CellTile& tile, bool smooth) {
  Image& image = images_[tile];
  image.used = draws_;
  if (image.handle != 0) return image.handle;
  const int across = pyramid_->cells_across(tile), up = pyramid_->cells_up(tile);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(4 * across * up));
  for (int y = up - 1; y >= 0; --y)
    for (int x = 0; x < across; ++x) {
      const std::uint8_t value = pyramid_->value(tile.level, tile.x * CellPyramid::kTile + x,
                                                 tile.y * CellPyramid::kTile + y);
      pixels.insert(pixels.end(), colors_[value].begin(), colors_[value].end());
    }
  image.handle = nvgCreateImageRGBA(ctx, across, up, smooth ? 0 : NVG_IMAGE_NEAREST, pixels.data());
  return image.handle;
}

void TileImages::forget_unseen(NVGcontext* ctx) {
  while (images_.size() > kMost) {
    const auto oldest = std::min_element(
        images_.begin(), images_.end(),
        [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    if (oldest->second.used == draws_) return;
    nvgDeleteImage(ctx, oldest->second.handle);
    images_.erase(oldest);
  }
}

}  // namespace slalom
