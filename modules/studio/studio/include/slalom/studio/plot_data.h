// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/list_view.h>
#include <slalom/studio/palette.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// 1, 2 or 5 times a power of ten.
struct RoundStep {
  int digit = 1;
  int exponent = 0;

  double size() const { return times(1); }
  /// `count` steps, correctly rounded: 3 steps of 0.1 are 0.3.
  double times(double count) const;
  /// The label of a multiple of the step, with the digits that the step needs.
  std::string label(double value) const;
};

/// The smallest step that divides [low, high] into at most `max_steps` parts (at least 1). For an
/// empty range, a step that is small relative to its value.
RoundStep round_step(double low, double high, int max_steps);

/// Maps values to pixels along one axis of a plot.
class PlotAxis {
 public:
  PlotAxis() = default;
  /// `low` is drawn at `low_pixel`. An empty range is widened around its value.
  PlotAxis(double low, double high, double low_pixel, double high_pixel);

  double low() const { return low_; }
  double high() const { return high_; }
  double to_pixel(double value) const;
  double to_value(double pixel) const;

  struct Tick {
    double value;
    std::string label;
  };
  /// At most `max_steps` + 1 round values within the range.
  std::vector<Tick> ticks(int max_steps) const;

 private:
  double low_ = 0, high_ = 1;
  double low_pixel_ = 0, high_pixel_ = 1;
};

/// One line of a plot. `x` is ascending and as long as `y`; NaN in `y` is a gap.
struct LineSeries {
  std::string name;
  Color color;
  std::vector<double> x, y;

  /// Linear interpolation at `at`; nullopt outside the samples and in gaps.
  std::optional<double> value_at(double at) const;
};

using Interval = std::pair<double, double>;
/// Extends the range to include the value.
void widen(std::optional<Interval>& range, double value);
/// The minimum and maximum of the finite numbers; nullopt if there are none.
std::optional<Interval> range_of(const std::vector<double>& numbers);

/// Indices of the samples that suffice to draw the line on this many pixel columns: of each column
/// the first, the minimum, the maximum and the last sample, and every gap.
std::vector<std::size_t> downsampled(const LineSeries& series, double x_low, double x_high,
                                     int columns);

/// The distribution of a descriptor in a list. Bins are half-open, low <= v < high, as in
/// "density >= 0.1 and density < 0.2"; their edges are round numbers and cover all values.
struct Histogram {
  struct Bar {
    double low, high;
    std::size_t count;
    std::string label;  ///< "[0.1, 0.2)"
  };
  std::vector<Bar> bars;         ///< contiguous; empty if there is no number
  std::size_t na = 0;            ///< scenarios whose value is NA
  std::size_t not_computed = 0;  ///< scenarios without a computed value

  std::size_t max_count() const;
  std::optional<std::size_t> bar_of(double value) const;  ///< the bar that contains this value
};

/// With about `max_bars` bars. The edges are integers if all values are.
Histogram make_histogram(const ListColumn& column, int max_bars = 24);

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
  std::optional<Interval> x_range() const { return x_range_; }
  std::optional<Interval> y_range() const { return y_range_; }

  /// Rows of the points within the closed rectangle between two opposite corners (values, not
  /// pixels).
  std::vector<std::size_t> within(double x0, double y0, double x1, double y1) const;
  /// The row of the point closest to a pixel, at most `radius` pixels away.
  std::optional<std::size_t> nearest(const PlotAxis& x, const PlotAxis& y, double pixel_x,
                                     double pixel_y, double radius) const;

 private:
  std::vector<Point> points_;
  std::size_t skipped_ = 0;
  std::optional<Interval> x_range_, y_range_;
};

/// Draws the points as dots on a transparent image: RGBA, not premultiplied, `width` x `height`,
/// with the upper left corner at (left, top) of the axes' pixels. The opacity of a pixel grows with
/// the number of dots.
std::vector<std::uint8_t> draw_dots(const Scatter& scatter, const PlotAxis& x, const PlotAxis& y,
                                    int left, int top, int width, int height, const Color& color);

}  // namespace slalom
