#pragma once

#include <slalom/gui/list_values.h>
#include <slalom/gui/plot_axes.h>

#include <cstddef>
#include <cstdint>
#include <nanogui/common.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The scenarios of a list as points over two descriptors: those that have both numbers.
class Scatter {
 public:
  Scatter() = default;
  Scatter(const ListColumn& x, const ListColumn& y);

  struct Point {
    double x, y;
    std::size_t row;  ///< in the list
  };
  const std::vector<Point>& points() const { return points_; }  ///< in the order of the list
  std::size_t left_out() const { return left_out_; }            ///< scenarios that lack a number
  /// nullopt when there is no point.
  std::optional<std::pair<double, double>> x_range() const { return x_range_; }
  std::optional<std::pair<double, double>> y_range() const { return y_range_; }

  /// Rows of the points within a rectangle between two opposite corners (values, not pixels), its
  /// border included.
  std::vector<std::size_t> within(double x0, double y0, double x1, double y1) const;
  /// The row of the point that is nearest to a pixel, at most `radius` pixels away.
  std::optional<std::size_t> nearest(const PlotAxis& x, const PlotAxis& y, double pixel_x,
                                     double pixel_y, double radius) const;

 private:
  std::vector<Point> points_;
  std::size_t left_out_ = 0;
  std::optional<std::pair<double, double>> x_range_, y_range_;
};

/// The points as dots on a transparent picture: RGBA, not premultiplied, `width` x `height`, whose
/// upper left corner is at (left, top) of the axes' pixels. The more dots lie on a pixel, the more
/// opaque it is.
std::vector<std::uint8_t> draw_dots(const Scatter& scatter, const PlotAxis& x, const PlotAxis& y,
                                    int left, int top, int width, int height,
                                    const nanogui::Color& color);

}  // namespace slalom
