#define GL_GLEXT_PROTOTYPES  // for the functions of OpenGL 3
#include <slalom/gui/tile_images.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace slalom {
namespace {

std::uint8_t byte_of(float part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
}

/// `over` (with its opacity) upon an opaque pixel.
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

/// What is drawn now stays within `rect` (pixels of the view).
void scissor(const ScreenRect& rect, const FramePlace& place) {
  const auto pixel = [&place](double x) { return static_cast<int>(std::lround(x * place.ratio)); };
  const int left = pixel(place.left + rect.left),
            right = pixel(place.left + rect.left + rect.width);
  const int top = pixel(place.height - place.top - rect.top);
  const int bottom = pixel(place.height - place.top - rect.top - rect.height);
  glScissor(left, bottom, right - left, top - bottom);
}

void clear(const ScreenRect& rect, const FramePlace& place, const nanogui::Color& color) {
  scissor(rect, place);
  glClearColor(color.r(), color.g(), color.b(), 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

ColorScalePtr blend_scale(const nanogui::Color& at_zero, const nanogui::Color& at_most) {
  auto scale = std::make_shared<ColorScale>();
  for (std::size_t value = 0; value < scale->size(); ++value)
    for (int c = 0; c < 4; ++c) {
      const float part = static_cast<float>(value) / 255;
      (*scale)[value][static_cast<std::size_t>(c)] =
          byte_of(at_zero[c] * (1 - part) + at_most[c] * part);
    }
  return scale;
}

std::vector<std::uint8_t> compose_tile(const std::vector<CellPicture>& pictures,
                                       const CellTile& tile, const nanogui::Color& floor) {
  const CellPyramid& grid = *pictures.front().pyramid;
  const int across = grid.cells_across(tile), up = grid.cells_up(tile);
  const std::array<std::uint8_t, 4> base = {byte_of(floor.r()), byte_of(floor.g()),
                                            byte_of(floor.b()), 255};
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * across * up));
  for (auto pixel = pixels.begin(); pixel != pixels.end(); pixel += 4)
    std::copy(base.begin(), base.end(), pixel);
  for (const CellPicture& picture : pictures) {
    std::uint8_t* pixel = pixels.data();
    for (int y = 0; y < up; ++y) {
      const std::uint8_t* value =
          picture.pyramid->row(tile.level, tile.y * CellPyramid::kTile + y) +
          tile.x * CellPyramid::kTile;
      for (int x = 0; x < across; ++x, pixel += 4) blend(pixel, (*picture.colors)[value[x]]);
    }
  }
  return pixels;
}

TileCut cut_tile(const CellPyramid& pyramid, const CellTile& tile, const ViewTransform& view,
                 double ratio) {
  const Bounds all = pyramid.bounds_of(tile), seen = view.visible();
  const double cell = (all.x_max - all.x_min) / pyramid.cells_across(tile);
  const auto range = [cell](double from, double to, double origin, int cells) {
    const double first = std::floor((from - origin) / cell), last = std::ceil((to - origin) / cell);
    return std::pair(static_cast<int>(std::clamp(first, 0.0, static_cast<double>(cells))),
                     static_cast<int>(std::clamp(last, 0.0, static_cast<double>(cells))));
  };
  TileCut cut;
  std::tie(cut.cell_left, cut.cell_right) =
      range(seen.x_min, seen.x_max, all.x_min, pyramid.cells_across(tile));
  std::tie(cut.cell_low, cut.cell_high) =
      range(seen.y_min, seen.y_max, all.y_min, pyramid.cells_up(tile));
  const auto pixels = [&](int cx, int cy) {
    return view.to_screen({all.x_min + cx * cell, all.y_min + cy * cell}) * ratio;
  };
  const auto low = pixels(cut.cell_left, cut.cell_low),
             high = pixels(cut.cell_right, cut.cell_high);
  cut.left = static_cast<int>(std::lround(low.x));
  cut.bottom = static_cast<int>(std::lround(low.y));
  cut.right = static_cast<int>(std::lround(high.x));
  cut.top = static_cast<int>(std::lround(high.y));
  return cut;
}

void TileImages::draw(const std::vector<CellPicture>& pictures, const nanogui::Color& floor_color,
                      const nanogui::Color& outside, const ScreenRect& floor,
                      const ScreenRect& clip, const ViewTransform& view, const FramePlace& place) {
  ++draws_;
  if (!(pictures == pictures_)) forget_all();
  pictures_ = pictures;
  glEnable(GL_SCISSOR_TEST);
  clear(clip, place, outside);
  clear(intersection(floor, clip), place, floor_color);
  if (!pictures_.empty()) {
    scissor(clip, place);
    const CellPyramid& grid = *pictures_.front().pyramid;
    const int level = grid.level_for(view.pixels_per_metre() * place.ratio);
    for (const CellTile& tile : grid.tiles_in(level, view.visible()))
      draw_tile(tile, floor_color, view, place);
  }
  glDisable(GL_SCISSOR_TEST);
  forget_unseen();
}

/// OpenGL counts rows from below, in the texture as in the window.
void TileImages::draw_tile(const CellTile& tile, const nanogui::Color& floor,
                           const ViewTransform& view, const FramePlace& place) {
  const TileCut cut = cut_tile(*pictures_.front().pyramid, tile, view, place.ratio);
  if (cut.left >= cut.right || cut.top >= cut.bottom) return;
  const unsigned texture = texture_of(tile, floor);
  if (source_ == 0) glGenFramebuffers(1, &source_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source_);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const int x = static_cast<int>(std::lround(place.left * place.ratio));
  const int y = static_cast<int>(std::lround((place.height - place.top) * place.ratio));
  glBlitFramebuffer(cut.cell_left, cut.cell_low, cut.cell_right, cut.cell_high, x + cut.left,
                    y - cut.bottom, x + cut.right, y - cut.top, GL_COLOR_BUFFER_BIT,
                    tile.level == 0 ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

unsigned TileImages::texture_of(const CellTile& tile, const nanogui::Color& floor) {
  Image& image = images_[tile];
  image.used = draws_;
  if (image.texture != 0) return image.texture;
  const CellPyramid& grid = *pictures_.front().pyramid;
  glGenTextures(1, &image.texture);
  glBindTexture(GL_TEXTURE_2D, image.texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, grid.cells_across(tile), grid.cells_up(tile), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, compose_tile(pictures_, tile, floor).data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return image.texture;
}

void TileImages::forget_all() {
  for (const auto& [tile, image] : images_) glDeleteTextures(1, &image.texture);
  images_.clear();
}

void TileImages::forget_unseen() {
  while (images_.size() > kMost) {
    const auto oldest = std::min_element(
        images_.begin(), images_.end(),
        [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    if (oldest->second.used == draws_) return;
    glDeleteTextures(1, &oldest->second.texture);
    images_.erase(oldest);
  }
}

}  // namespace slalom
