// SPDX-License-Identifier: BSD-3-Clause
#include "tune_hardest_quartile.h"

#include <slalom/core/text.h>
#include <slalom/statistics/quantile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace slalom {

namespace {

/// A quartile with three digits, so that what people read is what holds.
double rounded_quartile(const std::vector<double>& sorted, double fraction) {
  double value = quantile(sorted, fraction);
  parse_number(fmt::format("{:.3g}", value), value);
  return value;
}

}  // namespace

std::optional<HardestQuartile> hardest_quartile(const std::string& id,
                                                const std::vector<double>& sealed,
                                                const std::vector<double>& finals,
                                                const std::vector<TuneOutcome>& default_finals) {
  std::vector<double> sorted;
  std::copy_if(sealed.begin(), sealed.end(), std::back_inserter(sorted),
               [](double value) { return std::isfinite(value); });
  if (sorted.empty()) return std::nullopt;
  std::sort(sorted.begin(), sorted.end());
  const double low = rounded_quartile(sorted, 0.25), high = rounded_quartile(sorted, 0.75);
  if (!(low < high)) return std::nullopt;
  TuneCounts at_low, at_high;
  for (std::size_t i = 0; i < default_finals.size(); ++i)
    for (auto& [counts, beyond] :
         {std::pair(&at_low, finals[i] <= low), {&at_high, finals[i] >= high}}) {
      counts->runs += beyond ? 1 : 0;
      counts->successes += beyond && default_finals[i].success ? 1 : 0;
    }
  if (at_low.runs == 0 || at_high.runs == 0) return std::nullopt;
  const bool is_low = at_low.rate() < at_high.rate();
  HardestQuartile end{id + (is_low ? " <= " + format_number(low) : " >= " + format_number(high)),
                      {}};
  for (const double value : sealed) end.contains.push_back(is_low ? value <= low : value >= high);
  return end;
}

}  // namespace slalom
