// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/studio/plot_data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

constexpr int kMaxExponent = 307;

/// The smallest step that is distinguishable in values of this magnitude.
double min_step(double low, double high) {
  constexpr double kRelative = 1e-12;
  return std::max(std::abs(low), std::abs(high)) * kRelative;
}

RoundStep round_step_above(double size) {
  const int exponent =
      std::clamp(static_cast<int>(std::floor(std::log10(size))), -kMaxExponent, kMaxExponent);
  for (const int digit : {1, 2, 5})
    if (RoundStep{digit, exponent}.size() >= size * (1 - 1e-9)) return {digit, exponent};
  return {1, exponent + 1};
}

/// The samples to draw of one pixel column.
struct ColumnExtremes {
  std::size_t first, min, max, last;

  explicit ColumnExtremes(std::size_t i) : first(i), min(i), max(i), last(i) {}
  void add(std::size_t i, const std::vector<double>& y) {
    if (y[i] < y[min]) min = i;
    if (y[i] > y[max]) max = i;
    last = i;
  }
  void write(std::vector<std::size_t>& indices) const {
    for (const std::size_t i : {first, std::min(min, max), std::max(min, max), last})
      if (indices.empty() || indices.back() < i) indices.push_back(i);
  }
};

bool all_integers(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](double v) { return std::isnan(v) || v == std::floor(v); });
}

RoundStep bar_width(const ListColumn& column, double low, double high, int max_bars) {
  RoundStep step = round_step(low, high, max_bars);
  if (step.exponent < 0 && all_integers(column.numbers())) step = {1, 0};
  return step;
}

/// The number of steps up to the edge at or below `value`.
double steps_below(const RoundStep& step, double value) {
  double count = std::floor(value / step.size());
  while (step.times(count) > value) --count;
  while (step.times(count + 1) <= value) ++count;
  return count;
}

constexpr int kDotRadius = 2;            ///< pixels
constexpr std::size_t kFewPoints = 500;  ///< up to this number, points are drawn nearly opaque

/// The opacity by the number of overlapping dots.
std::array<std::uint8_t, 256> opacities(std::size_t points) {
  const double one = points <= kFewPoints ? 0.85 : points <= 20 * kFewPoints ? 0.5 : 0.1;
  std::array<std::uint8_t, 256> all{};
  for (std::size_t n = 0; n < all.size(); ++n)
    all[n] = static_cast<std::uint8_t>(
        std::lround(255 * (1 - math::pow(1 - one, static_cast<double>(n)))));
  return all;
}

}  // namespace

double RoundStep::times(double count) const {
  const double power = math::pow(10.0, std::abs(exponent));
  return exponent < 0 ? count * digit / power : count * digit * power;
}

std::string RoundStep::label(double value) const {
  if (value == 0) return "0";
  if (exponent < -6 || exponent > 6) return format_number(value);
  return format_fixed(value, std::max(0, -exponent));
}

RoundStep round_step(double low, double high, int max_steps) {
  double wanted = high / max_steps - low / max_steps;
  if (!(wanted > 0)) wanted = low == 0 ? 1 : 0.1 * std::abs(low);
  wanted = std::max(wanted, min_step(low, high));
  return round_step_above(wanted);
}

PlotAxis::PlotAxis(double low, double high, double low_pixel, double high_pixel)
    : low_(low), high_(high), low_pixel_(low_pixel), high_pixel_(high_pixel) {
  const double min_half = std::max(min_step(low, high), low == 0 && high == 0 ? 0.5 : 0.0);
  if (high_ - low_ >= 2 * min_half && high_ > low_) return;
  const double margin = low == 0 ? 0.5 : 0.1 * std::abs(low);
  low_ = low - margin;
  high_ = low + margin;
}

double PlotAxis::to_pixel(double value) const {
  return low_pixel_ + (value - low_) / (high_ - low_) * (high_pixel_ - low_pixel_);
}

double PlotAxis::to_value(double pixel) const {
  return low_ + (pixel - low_pixel_) / (high_pixel_ - low_pixel_) * (high_ - low_);
}

std::vector<PlotAxis::Tick> PlotAxis::ticks(int max_steps) const {
  const RoundStep step = round_step(low_, high_, std::max(max_steps, 1));
  const double slack = 1e-9 * step.size();
  std::vector<Tick> ticks;
  for (double k = std::ceil((low_ - slack) / step.size()); step.times(k) <= high_ + slack; ++k)
    ticks.push_back({step.times(k), step.label(step.times(k))});
  return ticks;
}

std::optional<double> LineSeries::value_at(double at) const {
  if (x.empty() || !(at >= x.front() && at <= x.back())) return std::nullopt;
  const auto after = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (x[after] == at) return std::isnan(y[after]) ? std::nullopt : std::optional(y[after]);
  const double fraction = (at - x[after - 1]) / (x[after] - x[after - 1]);
  const double value = y[after - 1] + fraction * (y[after] - y[after - 1]);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void widen(std::optional<Interval>& range, double value) {
  if (!range) range = {value, value};
  range->first = std::min(range->first, value);
  range->second = std::max(range->second, value);
}

std::optional<Interval> range_of(const std::vector<double>& numbers) {
  std::optional<Interval> range;
  for (const double number : numbers) {
    if (std::isfinite(number)) widen(range, number);
  }
  return range;
}

std::vector<std::size_t> downsampled(const LineSeries& series, double x_low, double x_high,
                                     int columns) {
  std::vector<std::size_t> indices;
  std::optional<ColumnExtremes> column;
  double current = 0;
  const auto close = [&] {
    if (column) column->write(indices);
    column.reset();
  };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::isnan(series.y[i])) {
      close();
      indices.push_back(i);
      continue;
    }
    const double index = std::floor((series.x[i] - x_low) / (x_high - x_low) * columns);
    if (column && index == current) {
      column->add(i, series.y);
    } else {
      close();
      column.emplace(i);
      current = index;
    }
  }
  close();
  return indices;
}

std::size_t Histogram::max_count() const {
  std::size_t max = 0;
  for (const Bar& bar : bars) max = std::max(max, bar.count);
  return max;
}

std::optional<std::size_t> Histogram::bar_of(double value) const {
  const auto after = std::upper_bound(bars.begin(), bars.end(), value,
                                      [](double v, const Bar& bar) { return v < bar.low; });
  if (after == bars.begin() || !(value < std::prev(after)->high)) return std::nullopt;
  return static_cast<std::size_t>(after - bars.begin() - 1);
}

Histogram make_histogram(const ListColumn& column, int max_bars) {
  Histogram histogram;
  histogram.na = column.na_count();
  histogram.not_computed = column.not_computed_count();
  const auto range = range_of(column.numbers());
  if (!range) return histogram;
  const RoundStep step = bar_width(column, range->first, range->second, max_bars);
  const double first = steps_below(step, range->first), last = steps_below(step, range->second);
  for (double k = first; k <= last; ++k) {
    const double low = step.times(k), high = step.times(k + 1);
    histogram.bars.push_back({low, high, 0, "[" + step.label(low) + ", " + step.label(high) + ")"});
  }
  for (const double number : column.numbers())
    if (const auto bar = histogram.bar_of(number)) ++histogram.bars[*bar].count;
  return histogram;
}

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
        math::hypot(x.to_pixel(point.x) - pixel_x, y.to_pixel(point.y) - pixel_y);
    if (distance > nearest_distance || (row && distance == nearest_distance)) continue;
    nearest_distance = distance;
    row = point.row;
  }
  return row;
}

std::vector<std::uint8_t> draw_dots(const Scatter& scatter, const PlotAxis& x, const PlotAxis& y,
                                    int left, int top, int width, int height, const Color& color) {
  std::vector<std::uint8_t> counts(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));  // of dots, at most 255
  for (const Scatter::Point& point : scatter.points()) {
    const int px = static_cast<int>(std::floor(x.to_pixel(point.x))) - left;
    const int py = static_cast<int>(std::floor(y.to_pixel(point.y))) - top;
    for (int v = std::max(py - kDotRadius, 0); v <= std::min(py + kDotRadius, height - 1); ++v)
      for (int u = std::max(px - kDotRadius, 0); u <= std::min(px + kDotRadius, width - 1); ++u) {
        if (math::hypot(u - px, v - py) > kDotRadius + 0.3) continue;
        std::uint8_t& count = counts[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(u)];
        if (count < 255) ++count;
      }
  }
  const auto opacity = opacities(scatter.points().size());
  const std::array<std::uint8_t, 3> rgb = {color.R, color.G, color.B};
  std::vector<std::uint8_t> image;
  image.reserve(4 * counts.size());
  for (const std::uint8_t count : counts) {
    image.insert(image.end(), rgb.begin(), rgb.end());
    image.push_back(opacity[count]);
  }
  return image;
}

}  // namespace slalom
