#pragma once

#include <slalom/studio/list_values.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/plot_axes.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The scenarios of a list as points in the plane of two descriptors; those with both numbers.
class Scatter {
 public:
  Scatter() = default;
  Scatter(const ListColumn& x, const ListColumn& y);

  struct Point {
    double x, y;
    std::size_t row;  ///< in the list
  };
  const std::vector<Point>& points() const { return points_; }  ///< in the order of the list
  std::size_t skipped() const { return skipped_; }              ///< scenarios without both values
  /// nullopt if there are no points.
  std::optional<std::pair<double, double>> x_range() const { return x_range_; }
  std::optional<std::pair<double, double>> y_range() const { return y_range_; }

  /// Rows of the points within the closed rectangle between two opposite corners (values, not
  /// pixels).
  std::vector<std::size_t> within(double x0, double y0, double x1, double y1) const;
  /// The row of the point closest to a pixel, at most `radius` pixels away.
  std::optional<std::size_t> nearest(const PlotAxis& x, const PlotAxis& y, double pixel_x,
                                     double pixel_y, double radius) const;

 private:
  std::vector<Point> points_;
  std::size_t skipped_ = 0;
  std::optional<std::pair<double, double>> x_range_, y_range_;
};

/// Draws the points as dots on a transparent image: RGBA, not premultiplied, `width` x `height`,
/// with the upper left corner at (left, top) of the axes' pixels. The opacity of a pixel grows with
/// the number of dots.
std::vector<std::uint8_t> draw_dots(const Scatter& scatter, const PlotAxis& x, const PlotAxis& y,
                                    int left, int top, int width, int height, const Color& color);

}  // namespace slalom
