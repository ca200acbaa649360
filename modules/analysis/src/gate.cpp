#include <slalom/analysis/gate.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <cmath>

namespace slalom {
namespace {

/// Sums of equal differences may miss a limit by their rounding.
constexpr double kRounding = 1e-12;

bool keeps(const Gate& gate, double number) {
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
  const std::size_t place = text.find_first_of("<>");
  const Error wrong =
      usage_error("gate '" + text + "'", "not understood", "METRIC >= NUMBER, or with <=, > or <");
  if (place == std::string::npos) throw wrong;
  const bool or_equal = place + 1 < text.size() && text[place + 1] == '=';
  const bool more = text[place] == '>';
  using Comparison = Gate::Comparison;
  gate.comparison = more ? (or_equal ? Comparison::AtLeast : Comparison::Above)
                         : (or_equal ? Comparison::AtMost : Comparison::Below);
  gate.metric = trim(text.substr(0, place));
  const std::string number = trim(text.substr(place + (or_equal ? 2 : 1)));
  if (gate.metric.empty() || !parse_number(number, gate.limit) || !std::isfinite(gate.limit)) {
    throw wrong;
  }
  return gate;
}

std::vector<GateResult> judge_gate(const Gate& gate, const std::vector<PairedComparison>& family,
                                   GateOn on) {
  std::vector<GateResult> results;
  for (const PairedComparison& comparison : family) {
    if (comparison.column.info.id != gate.metric) continue;
    GateResult result{gate,  comparison.a, comparison.b, comparison.difference, comparison.interval,
                      false, false};
    if (on == GateOn::Estimate && result.difference) {
      result.judged = true;
      result.passed = keeps(gate, *result.difference);
    } else if (on == GateOn::Interval && result.interval) {
      result.judged = true;
      result.passed = keeps(gate, result.interval->low) && keeps(gate, result.interval->high);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace slalom
