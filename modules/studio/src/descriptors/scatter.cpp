#include <slalom/studio/scatter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using OptionalInterval = std::optional<std::pair<double, double>>;

constexpr int kDotRadius = 2;            ///< pixels
constexpr std::size_t kFewPoints = 500;  ///< up to this number, points are drawn nearly opaque

void widen(OptionalInterval& range, double value) {
  if (!range) range = {value, value};
  range->first = std::min(range->first, value);
  range->second = std::max(range->second, value);
}

/// The number of dots on each pixel, at most 255.
class DotCounts {
 public:
  DotCounts(int width, int height)
      : width_(width),
        height_(height),
        counts_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void add(int x, int y) {
    for (int dy = -kDotRadius; dy <= kDotRadius; ++dy)
      for (int dx = -kDotRadius; dx <= kDotRadius; ++dx)
        if (dx * dx + dy * dy <= kDotRadius * kDotRadius + 1) count(x + dx, y + dy);
  }
  const std::vector<std::uint8_t>& counts() const { return counts_; }

 private:
  void count(int x, int y) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    std::uint8_t& pixel = counts_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x)];
    if (pixel < 255) ++pixel;
  }
  int width_, height_;
  std::vector<std::uint8_t> counts_;
};

/// The opacity by the number of overlapping dots.
std::array<std::uint8_t, 256> opacities(std::size_t points) {
  const double one = points <= kFewPoints ? 0.85 : points <= 20 * kFewPoints ? 0.5 : 0.1;
  std::array<std::uint8_t, 256> all{};
  for (std::size_t n = 0; n < all.size(); ++n)
    all[n] = static_cast<std::uint8_t>(
        std::lround(255 * (1 - std::pow(1 - one, static_cast<double>(n)))));
  return all;
}

}  // namespace

Scatter::Scatter(const ListColumn& x, const ListColumn& y) {
  const std::size_t rows = std::min(x.size(), y.size());
  for (std::size_t row = 0; row < rows; ++row) {
    if (!x.has_number(row) || !y.has_number(row)) {
      ++skipped_;
      continue;
    }
    points_.push_back({x.number(row), y.number(row), row});
    widen(x_range_, x.number(row));
    widen(y_range_, y.number(row));
  }
}

std::vector<std::size_t> Scatter::within(double x0, double y0, double x1, double y1) const {
  const auto [left, right] = std::minmax(x0, x1);
  const auto [low, high] = std::minmax(y0, y1);
  std::vector<std::size_t> rows;
  for (const Point& point : points_)
    if (point.x >= left && point.x <= right && point.y >= low && point.y <= high)
      rows.push_back(point.row);
  return rows;
}

std::optional<std::size_t> Scatter::nearest(const PlotAxis& x, const PlotAxis& y, double pixel_x,
                                            double pixel_y, double radius) const {
  std::optional<std::size_t> row;
  double nearest_distance = radius;
  for (const Point& point : points_) {
    const double distance =
        std::hypot(x.to_pixel(point.x) - pixel_x, y.to_pixel(point.y) - pixel_y);
    if (distance > nearest_distance || (row && distance == nearest_distance)) continue;
    nearest_distance = distance;
    row = point.row;
  }
  return row;
}

std::vector<std::uint8_t> draw_dots(const Scatter& scatter, const PlotAxis& x, const PlotAxis& y,
                                    int left, int top, int width, int height, const Color& color) {
  DotCounts dots(width, height);
  for (const Scatter::Point& point : scatter.points())
    dots.add(static_cast<int>(std::floor(x.to_pixel(point.x))) - left,
             static_cast<int>(std::floor(y.to_pixel(point.y))) - top);
  const auto opacity = opacities(scatter.points().size());
  const std::array<std::uint8_t, 3> rgb = {color.R, color.G, color.B};
  std::vector<std::uint8_t> image;
  image.reserve(4 * dots.counts().size());
  for (const std::uint8_t count : dots.counts()) {
    image.insert(image.end(), rgb.begin(), rgb.end());
    image.push_back(opacity[count]);
  }
  return image;
}

}  // namespace slalom
