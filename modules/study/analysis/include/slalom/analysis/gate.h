// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/paired_comparison.h>

#include <string>
#include <vector>

namespace slalom {

/// A regression gate: a limit on the paired difference of a metric, "success >= -0.02".
struct Gate {
  enum class Comparison { AtLeast, AtMost, Above, Below };
  std::string metric;
  Comparison comparison = Comparison::AtLeast;
  double limit = 0;
  std::string text;  ///< as specified
};

/// The quantity that must satisfy the limit.
enum class GateOn {
  Estimate,  ///< the mean paired difference
  Interval   ///< its entire confidence interval; of values without bounds that of their shift
};
constexpr auto enum_names(GateOn) {
  return std::array{"estimate", "interval"};
}

/// Reads METRIC OP NUMBER with OP one of >= <= > <. Throws Error (Usage).
Gate parse_gate(const std::string& text);

struct GateResult {
  Gate gate;
  std::string a, b;  ///< sides of the comparison
  std::optional<double> difference;
  std::optional<Interval> interval;
  std::size_t without_value = 0;  ///< pairs of runs that the difference leaves out
  bool evaluated = false;         ///< false if the quantity is not available; then not passed
  bool passed = false;
};

/// One result for each comparison in the gate's metric.
std::vector<GateResult> evaluate_gate(const Gate& gate, const std::vector<PairedComparison>& family,
                                      GateOn on);

}  // namespace slalom
