// SPDX-License-Identifier: BSD-3-Clause
#define GL_GLEXT_PROTOTYPES  // for the functions of OpenGL 3
#include "views/scene_layers.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace slalom {
namespace {

/// Blends `over` over an opaque pixel.
void blend(std::uint8_t* pixel, const std::array<std::uint8_t, 4>& over) {
  const int opacity = over[3];
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] =
        static_cast<std::uint8_t>((over[c] * opacity + pixel[c] * (255 - opacity) + 127) / 255);
}

ScreenRect intersection(const ScreenRect& a, const ScreenRect& b) {
  const double left = std::max(a.left, b.left), top = std::max(a.top, b.top);
  const double right = std::min(a.left + a.width, b.left + b.width);
  const double bottom = std::min(a.top + a.height, b.top + b.height);
  return {left, top, std::max(0.0, right - left), std::max(0.0, bottom - top)};
}

/// Restricts drawing to `rect` (pixels of the view).
void scissor(const ScreenRect& rect, const Viewport& viewport) {
  const auto pixel = [&viewport](double x) {
    return static_cast<int>(std::lround(x * viewport.ratio));
  };
  const int left = pixel(viewport.left + rect.left),
            right = pixel(viewport.left + rect.left + rect.width);
  const int top = pixel(viewport.height - viewport.top - rect.top);
  const int bottom = pixel(viewport.height - viewport.top - rect.top - rect.height);
  glScissor(left, bottom, right - left, top - bottom);
}

void clear(const ScreenRect& rect, const Viewport& viewport, const Color& color) {
  scissor(rect, viewport);
  const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255; };
  glClearColor(channel(color.R), channel(color.G), channel(color.B), 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

ColorScalePtr make_color_scale(const Color& at_min, const Color& at_max) {
  auto scale = std::make_shared<ColorScale>();
  for (std::size_t value = 0; value < scale->size(); ++value) {
    const Color color = interpolated(at_min, at_max, static_cast<double>(value) / 255);
    (*scale)[value] = {color.R, color.G, color.B, color.A};
  }
  return scale;
}

std::vector<std::uint8_t> compose_tile(const std::vector<ColoredCells>& layers,
                                       const CellTile& tile, const Color& background) {
  const CellPyramid& grid = *layers.front().pyramid;
  const int across = grid.tile_size_x(tile), up = grid.tile_size_y(tile);
  const std::array<std::uint8_t, 4> base = {background.R, background.G, background.B, 255};
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * across * up));
  for (auto pixel = pixels.begin(); pixel != pixels.end(); pixel += 4)
    std::copy(base.begin(), base.end(), pixel);
  for (const ColoredCells& layer : layers) {
    std::uint8_t* pixel = pixels.data();
    for (int y = 0; y < up; ++y) {
      const std::uint8_t* value =
          layer.pyramid->row(tile.level, tile.y * CellPyramid::kTileSize + y) +
          static_cast<std::ptrdiff_t>(tile.x) * CellPyramid::kTileSize;
      for (int x = 0; x < across; ++x, pixel += 4) blend(pixel, (*layer.colors)[value[x]]);
    }
  }
  return pixels;
}

TileClip clip_tile(const CellPyramid& pyramid, const CellTile& tile, const ViewTransform& view,
                   double ratio) {
  const Bounds all = pyramid.bounds_of(tile), visible = view.visible();
  const double cell = (all.x_max - all.x_min) / pyramid.tile_size_x(tile);
  const auto range = [cell](double from, double to, double origin, int cells) {
    const double first = std::floor((from - origin) / cell), last = std::ceil((to - origin) / cell);
    return std::pair(static_cast<int>(std::clamp(first, 0.0, static_cast<double>(cells))),
                     static_cast<int>(std::clamp(last, 0.0, static_cast<double>(cells))));
  };
  TileClip clip;
  std::tie(clip.cell_left, clip.cell_right) =
      range(visible.x_min, visible.x_max, all.x_min, pyramid.tile_size_x(tile));
  std::tie(clip.cell_low, clip.cell_high) =
      range(visible.y_min, visible.y_max, all.y_min, pyramid.tile_size_y(tile));
  const auto pixels = [&](int cx, int cy) {
    return view.to_screen({all.x_min + cx * cell, all.y_min + cy * cell}) * ratio;
  };
  const auto low = pixels(clip.cell_left, clip.cell_low),
             high = pixels(clip.cell_right, clip.cell_high);
  clip.left = static_cast<int>(std::lround(low.x));
  clip.bottom = static_cast<int>(std::lround(low.y));
  clip.right = static_cast<int>(std::lround(high.x));
  clip.top = static_cast<int>(std::lround(high.y));
  return clip;
}

void TileImages::draw(const std::vector<ColoredCells>& layers, const Color& background,
                      const Color& outside, const ScreenRect& extent, const ScreenRect& clip,
                      const ViewTransform& view, const Viewport& viewport) {
  ++draws_;
  if (!(layers == layers_)) delete_textures();
  layers_ = layers;
  glEnable(GL_SCISSOR_TEST);
  clear(clip, viewport, outside);
  clear(intersection(extent, clip), viewport, background);
  if (!layers_.empty()) {
    scissor(clip, viewport);
    const CellPyramid& grid = *layers_.front().pyramid;
    const int level = grid.level_for(view.pixels_per_meter() * viewport.ratio);
    for (const CellTile& tile : grid.tiles_in(level, view.visible()))
      draw_tile(tile, background, view, viewport);
  }
  glDisable(GL_SCISSOR_TEST);
  evict_textures();
}

/// OpenGL counts rows from the bottom, in the texture and in the window.
void TileImages::draw_tile(const CellTile& tile, const Color& background, const ViewTransform& view,
                           const Viewport& viewport) {
  const TileClip clip = clip_tile(*layers_.front().pyramid, tile, view, viewport.ratio);
  if (clip.left >= clip.right || clip.top >= clip.bottom) return;
  const unsigned texture = texture_of(tile, background);
  if (source_ == 0) glGenFramebuffers(1, &source_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source_);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const int x = static_cast<int>(std::lround(viewport.left * viewport.ratio));
  const int y = static_cast<int>(std::lround((viewport.height - viewport.top) * viewport.ratio));
  glBlitFramebuffer(clip.cell_left, clip.cell_low, clip.cell_right, clip.cell_high, x + clip.left,
                    y - clip.bottom, x + clip.right, y - clip.top, GL_COLOR_BUFFER_BIT,
                    tile.level == 0 ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

unsigned TileImages::texture_of(const CellTile& tile, const Color& background) {
  Image& image = images_[tile];
  image.used = draws_;
  if (image.texture != 0) return image.texture;
  const CellPyramid& grid = *layers_.front().pyramid;
  glGenTextures(1, &image.texture);
  glBindTexture(GL_TEXTURE_2D, image.texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, grid.tile_size_x(tile), grid.tile_size_y(tile), 0,
               GL_RGBA, GL_UNSIGNED_BYTE, compose_tile(layers_, tile, background).data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return image.texture;
}

void TileImages::delete_textures() {
  for (const auto& [tile, image] : images_) glDeleteTextures(1, &image.texture);
  images_.clear();
}

void TileImages::evict_textures() {
  while (images_.size() > kMaxImages) {
    const auto oldest = std::min_element(
        images_.begin(), images_.end(),
        [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    if (oldest->second.used == draws_) return;
    glDeleteTextures(1, &oldest->second.texture);
    images_.erase(oldest);
  }
}

}  // namespace slalom
