#include <slalom/gui/line_series.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// What is kept of the samples of one column.
struct ColumnExtremes {
  std::size_t first, least, largest, last;

  explicit ColumnExtremes(std::size_t i) : first(i), least(i), largest(i), last(i) {}
  void take(std::size_t i, const std::vector<double>& y) {
    if (y[i] < y[least]) least = i;
    if (y[i] > y[largest]) largest = i;
    last = i;
  }
  void write(std::vector<std::size_t>& kept) const {
    for (const std::size_t i : {first, std::min(least, largest), std::max(least, largest), last})
      if (kept.empty() || kept.back() < i) kept.push_back(i);
  }
};

}  // namespace

std::optional<double> LineSeries::value_at(double at) const {
  if (x.empty() || !(at >= x.front() && at <= x.back())) return std::nullopt;
  const auto after = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (x[after] == at) return std::isnan(y[after]) ? std::nullopt : std::optional(y[after]);
  const double share = (at - x[after - 1]) / (x[after] - x[after - 1]);
  const double value = y[after - 1] + share * (y[after] - y[after - 1]);
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

std::vector<std::size_t> thinned(const LineSeries& series, double x_low, double x_high,
                                 int columns) {
  std::vector<std::size_t> kept;
  std::optional<ColumnExtremes> column;
  double at = 0;
  const auto close = [&] {
    if (column) column->write(kept);
    column.reset();
  };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::isnan(series.y[i])) {
      close();
      kept.push_back(i);
      continue;
    }
    const double here = std::floor((series.x[i] - x_low) / (x_high - x_low) * columns);
    if (column && here == at) {
      column->take(i, series.y);
    } else {
      close();
      column.emplace(i);
      at = here;
    }
  }
  close();
  return kept;
}

}  // namespace slalom
