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

std::string brief(double number) {
  return format_fixed(number, digits_of(number));
}

std::string p_text(double p) {
  return p < 0.0001 ? "p < 0.0001" : "p = " + format_fixed(p, 4);
}

std::string evidence(const PairedComparison& c) {
  const int digits = digits_of(std::max(std::abs(*c.mean_a), std::abs(*c.mean_b)));
  std::string text = format_fixed(*c.mean_b, digits) + " against " +
                     format_fixed(*c.mean_a, digits) + ", difference " +
                     format_fixed(*c.difference, digits);
  if (c.interval) {
    text += " [" + format_fixed(c.interval->low, digits) + ", " +
            format_fixed(c.interval->high, digits) + "]";
  }
  return text + " over " + count_text(c.scenarios, "scenario") + ", " + p_text(c.adjusted_p) +
         " (" + to_string(c.test) + ", Holm)";
}

std::string power_text(const PairedComparison& c) {
  return "a difference of " + brief(c.relevant) + " with " + format_number(100 * c.power) +
         " % power";
}

std::string not_enough(const PairedComparison& c) {
  const std::string head =
      "not enough runs to compare " + c.b + " with " + c.a + " in " + c.column.info.id + ": ";
  if (c.scenarios == 0) {
    return head + "no pair has a value (" + count_text(c.without_value, "pair") + " without)";
  }
  if (c.scenarios_needed <= c.scenarios) {
    return head + evidence(c) + "; how many would do cannot be told";
  }
  return head + evidence(c) + "; about " +
         count_text(c.scenarios_needed - c.scenarios, "scenario") + " more would show " +
         power_text(c);
}

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::Better:
      return "better";
    case Verdict::Worse:
      return "worse";
    case Verdict::Different:
      return "different";
    case Verdict::NoDifference:
      return "no difference shown";
    case Verdict::NotEnough:
      return "not enough runs";
  }
  return "";
}

std::string to_string(PairedComparison::Test test) {
  switch (test) {
    case PairedComparison::Test::None:
      return "no test";
    case PairedComparison::Test::McNemarExact:
      return "exact McNemar test";
    case PairedComparison::Test::SignedRankExact:
      return "exact signed-rank test";
    case PairedComparison::Test::SignedRankNormal:
      return "signed-rank test";
  }
  return "";
}

std::string verdict_sentence(const PairedComparison& c) {
  const std::string& metric = c.column.info.id;
  switch (c.verdict) {
    case Verdict::NotEnough:
      return not_enough(c);
    case Verdict::NoDifference:
      return "no difference shown between " + c.b + " and " + c.a + " in " + metric + ": " +
             evidence(c) + "; " + count_text(c.scenarios_needed, "scenario") + " show " +
             power_text(c);
    case Verdict::Different:
      return c.b + " differs from " + c.a + " in " + metric + ": " + evidence(c);
    case Verdict::Better:
    case Verdict::Worse:
      break;
  }
  return c.b + " is " + to_string(c.verdict) + " than " + c.a + " in " + metric + ": " +
         evidence(c);
}

}  // namespace slalom
