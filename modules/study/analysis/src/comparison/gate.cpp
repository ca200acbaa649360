// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/gate.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <cmath>

namespace slalom {
namespace {

/// Tolerance for the rounding error of sums.
constexpr double kRounding = 1e-12;

bool satisfies(const Gate& gate, double number) {
  switch (gate.comparison) {
    case Gate::Comparison::AtLeast:
      return number >= gate.limit - kRounding;
    case Gate::Comparison::AtMost:
      return number <= gate.limit + kRounding;
    case Gate::Comparison::Above:
      return number > gate.limit + kRounding;
    case Gate::Comparison::Below:
      return number < gate.limit - kRounding;
  }
  return false;
}

}  // namespace

Gate parse_gate(const std::string& text) {
  Gate gate;
  gate.text = trim(text);
  const std::size_t position = text.find_first_of("<>");
  const Error malformed =
      usage_error("gate '" + text + "'", "malformed", "METRIC >= NUMBER, or with <=, > or <");
  if (position == std::string::npos) throw malformed;
  const bool or_equal = position + 1 < text.size() && text[position + 1] == '=';
  const bool more = text[position] == '>';
  using Comparison = Gate::Comparison;
  gate.comparison = more ? (or_equal ? Comparison::AtLeast : Comparison::Above)
                         : (or_equal ? Comparison::AtMost : Comparison::Below);
  gate.metric = trim(text.substr(0, position));
  const std::string number = trim(text.substr(position + (or_equal ? 2 : 1)));
  if (gate.metric.empty() || !parse_number(number, gate.limit) || !std::isfinite(gate.limit)) {
    throw malformed;
  }
  return gate;
}

std::vector<GateResult> evaluate_gate(const Gate& gate, const std::vector<PairedComparison>& family,
                                      GateOn on) {
  std::vector<GateResult> results;
  for (const PairedComparison& comparison : family) {
    if (comparison.column.info.id != gate.metric) continue;
    GateResult result{gate,
                      comparison.a,
                      comparison.b,
                      comparison.difference,
                      comparison.interval,
                      comparison.without_value};
    if (on == GateOn::Interval && !result.interval && comparison.shift) {
      result.difference = comparison.shift->estimate;
      result.interval = comparison.shift->interval;
    }
    if (on == GateOn::Estimate && result.difference) {
      result.evaluated = true;
      result.passed = satisfies(gate, *result.difference);
    } else if (on == GateOn::Interval && result.interval) {
      result.evaluated = true;
      result.passed =
          satisfies(gate, result.interval->low) && satisfies(gate, result.interval->high);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace slalom
