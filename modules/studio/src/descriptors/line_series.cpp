#include <slalom/studio/line_series.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

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

}  // namespace

std::optional<double> LineSeries::value_at(double at) const {
  if (x.empty() || !(at >= x.front() && at <= x.back())) return std::nullopt;
  const auto after = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (x[after] == at) return std::isnan(y[after]) ? std::nullopt : std::optional(y[after]);
  const double fraction = (at - x[after - 1]) / (x[after] - x[after - 1]);
  const double value = y[after - 1] + fraction * (y[after] - y[after - 1]);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::optional<std::pair<double, double>> range_of(const std::vector<double>& numbers) {
  std::optional<std::pair<double, double>> range;
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    if (!range) range = {number, number};
    range->first = std::min(range->first, number);
    range->second = std::max(range->second, number);
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

}  // namespace slalom
