// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/contrast.h>
#include <slalom/statistics/paired_rates.h>
#include <slalom/statistics/quantile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

Interval quartiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.25), quantile(values, 0.75)};
}

Contrast contrast_of(const MatchedValues& values, double confidence) {
  const double tolerance = std::max(tie_tolerance(values.group), tie_tolerance(values.reference));
  std::vector<double> differences;
  Contrast contrast;
  contrast.quantity = values.quantity;
  contrast.pairs = values.group.size();
  for (std::size_t i = 0; i < values.group.size(); ++i) {
    differences.push_back(values.group[i] - values.reference[i]);
    contrast.higher += differences.back() > tolerance ? 1 : 0;
    contrast.lower += differences.back() < -tolerance ? 1 : 0;
  }
  contrast.group = quartiles(values.group);
  contrast.reference = quartiles(values.reference);
  contrast.difference = hodges_lehmann(differences, confidence);
  contrast.p = signed_rank_test(differences, tolerance).p;
  return contrast;
}

bool excludes_zero(const Shift& shift) {
  return shift.interval && (shift.interval->low > 0 || shift.interval->high < 0);
}

std::string three_digits(double number) {
  return fmt::format("{:.3g}", number);
}

std::string range_text(const Interval& range) {
  return three_digits(range.low) + " to " + three_digits(range.high);
}

}  // namespace

std::vector<Contrast> contrast_matched(const std::vector<MatchedValues>& values,
                                       double confidence) {
  std::vector<Contrast> contrasts;
  std::vector<double> p;
  for (const MatchedValues& one : values) {
    if (one.group.empty()) continue;
    contrasts.push_back(contrast_of(one, confidence));
    p.push_back(contrasts.back().p);
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < contrasts.size(); ++i) {
    contrasts[i].adjusted_p = adjusted[i];
    contrasts[i].holds =
        adjusted[i] <= test_level(confidence) && excludes_zero(contrasts[i].difference);
  }
  std::stable_sort(contrasts.begin(), contrasts.end(), [](const Contrast& a, const Contrast& b) {
    return a.holds != b.holds ? a.holds : a.holds && a.adjusted_p < b.adjusted_p;
  });
  return contrasts;
}

std::size_t min_pairs_to_hold(std::size_t family, double confidence) {
  std::size_t pairs = 1;
  while (std::ldexp(static_cast<double>(family), 1 - static_cast<int>(pairs)) >
         test_level(confidence))
    ++pairs;
  return pairs;
}

std::string contrast_sentence(const Contrast& contrast, const std::string& reference) {
  const bool higher = contrast.difference.estimate > 0;
  const std::string unit = contrast.quantity.unit == "-" ? "" : " " + contrast.quantity.unit;
  std::string text = fmt::format(
      "{} of {} have a {} {} than their {}: {}{}, {} {}{} (quartiles); difference {}",
      higher ? contrast.higher : contrast.lower, contrast.pairs, higher ? "higher" : "lower",
      contrast.quantity.name, reference, range_text(contrast.group), unit, reference,
      range_text(contrast.reference), unit, three_digits(contrast.difference.estimate));
  if (const auto& interval = contrast.difference.interval)
    text += fmt::format(" [{}, {}]", three_digits(interval->low), three_digits(interval->high));
  return text + unit + ", " + p_text(contrast.adjusted_p);
}

}  // namespace slalom
