#include <slalom/studio/histogram.h>
#include <slalom/studio/line_series.h>
#include <slalom/studio/plot_axes.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

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

}  // namespace

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

}  // namespace slalom
