// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

int digits_of(double number) {
  if (number == 0 || !std::isfinite(number)) return 2;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(number)))), 0, 6);
}

std::string short_number(double number) {
  return format_fixed(number, digits_of(number));
}

/// "30 scenarios", or "15 and 14 unpaired scenarios".
std::string sample_text(const PairedComparison& c) {
  if (!c.is_unpaired) return count_text(c.scenarios, "scenario");
  return std::to_string(c.scenarios_a) + " and " + count_text(c.scenarios_b, "unpaired scenario");
}

/// ", ratio of geometric means 0.912 [0.850, 0.978]", or the shift, if that decides.
std::string deciding_text(const PairedComparison& c, int digits) {
  if (c.column.info.is_rate() || c.column.info.kind == QuantityKind::Score) return "";
  if (c.ratio_interval)
    return ", ratio of geometric means " + estimate_text(*c.ratio, c.ratio_interval, 3);
  if (!c.shift || !c.shift->interval) return "";
  return ", shift " + estimate_text(c.shift->estimate, c.shift->interval, digits);
}

std::string statistics_text(const PairedComparison& c) {
  const int digits = digits_of(std::max(std::abs(*c.mean_a), std::abs(*c.mean_b)));
  const std::string text =
      format_fixed(*c.mean_b, digits) + " against " + format_fixed(*c.mean_a, digits) +
      ", difference " + estimate_text(*c.difference, c.interval, digits) + deciding_text(c, digits);
  return text + " over " + sample_text(c) + ", " + p_text(c.adjusted_p) + " (" + to_string(c.test) +
         ", " + family_text(c) + ")";
}

std::string power_text(const PairedComparison& c) {
  return "a difference of " + short_number(c.relevant) + " with " + percent_text(c.power) +
         " % power";
}

std::string more_text(const PairedComparison& c) {
  constexpr std::size_t kMost = 100000;  // near 0 a share of the mean is tiny
  if (c.required_scenarios > kMost)
    return "; " + power_text(c) + " would require more than " + std::to_string(kMost) +
           " scenarios";
  return "; about " + count_text(c.required_scenarios - c.scenarios, "more scenario") +
         (c.is_unpaired ? " of each" : "") + " required for " + power_text(c);
}

std::string not_enough(const PairedComparison& c) {
  const std::string head =
      "not enough runs to compare " + c.b + " with " + c.a + " in " + c.column.info.id + ": ";
  if (c.is_unpaired && c.scenarios == 0)
    return head + "no values (" + count_text(c.runs_without_value, "run") + " without)";
  if (!c.is_unpaired && !c.has_partners()) return head + "no common scenario and repetition";
  if (c.scenarios == 0) {
    return head + "no pair with values (" + count_text(c.without_value, "pair") + " without)";
  }
  if (c.required_scenarios <= c.scenarios) {
    return head + statistics_text(c) + "; the required sample size cannot be estimated";
  }
  return head + statistics_text(c) + more_text(c);
}

/// Why the interval and the test disagree.
std::string unconfirmed(const PairedComparison& c) {
  const std::string head = "the difference between " + c.b + " and " + c.a + " in " +
                           c.column.info.id + " is not confirmed: " + statistics_text(c) + "; ";
  const DecidingInterval deciding = deciding_interval(c);
  const std::string null = format_number(deciding.null);
  if (c.adjusted_p <= test_level(c.confidence))
    return head + "the test rejects equality, but " +
           (deciding.interval ? "the interval includes " + null : "there is no interval");
  const std::string correction =
      c.p <= test_level(c.confidence) ? " after the correction (before: " + p_text(c.p) + ")" : "";
  return head + "the interval excludes " + null + ", but the test does not reject equality" +
         correction + (c.required_scenarios > c.scenarios ? more_text(c) : "");
}

}  // namespace

std::string family_text(const PairedComparison& c) {
  return "Holm over " + count_text(c.family, "pair") +
         (c.baseline.empty() ? "" : " with " + c.baseline);
}

std::string verdict_sentence(const PairedComparison& c) {
  const std::string& metric = c.column.info.id;
  switch (c.verdict) {
    case Verdict::NotEnough:
      return not_enough(c);
    case Verdict::NoDifference:
      return "no difference shown between " + c.b + " and " + c.a + " in " + metric + ": " +
             statistics_text(c) + "; " + count_text(c.required_scenarios, "scenario") +
             (c.is_unpaired ? " of each" : "") + " suffice for " + power_text(c);
    case Verdict::Unconfirmed:
      return unconfirmed(c);
    case Verdict::Identical:
      return c.b + " and " + c.a + " are identical in " + metric + ": equal values in " +
             count_text(c.pairs, "pair") + " of runs over " + count_text(c.scenarios, "scenario");
    case Verdict::Different:
      return c.b + " differs from " + c.a + " in " + metric + ": " + statistics_text(c);
    case Verdict::OtherSettings:
      return "no verdict on " + c.b + " against " + c.a + " in " + metric +
             ": their campaigns have other settings (--despite-settings compares them)";
    case Verdict::Better:
    case Verdict::Worse:
      break;
  }
  return c.b + " is " + to_string(c.verdict) + " than " + c.a + " in " + metric + ": " +
         statistics_text(c);
}

}  // namespace slalom
