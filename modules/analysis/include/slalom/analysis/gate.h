#pragma once

#include <slalom/analysis/paired_comparison.h>

#include <string>
#include <vector>

namespace slalom {

/// A limit to the paired difference of a metric: "success >= -0.02".
struct Gate {
  enum class Comparison { AtLeast, AtMost, Above, Below };
  std::string metric;
  Comparison comparison = Comparison::AtLeast;
  double limit = 0;
  std::string text;  ///< as it was written
};

/// Which number has to keep to the limit.
enum class GateOn {
  Estimate,  ///< the mean paired difference
  Interval   ///< its whole interval: the difference is shown to keep to the limit
};

/// Reads METRIC OP NUMBER with OP one of >= <= > <. Throws Error (Usage).
Gate parse_gate(const std::string& text);

struct GateResult {
  Gate gate;
  std::string a, b;  ///< sides of the comparison
  std::optional<double> difference;
  std::optional<Interval> interval;
  bool judged = false;  ///< false: there is no such number; then not passed
  bool passed = false;
};

/// One result for each comparison in the gate's metric; none where no comparison is in it.
std::vector<GateResult> judge_gate(const Gate& gate, const std::vector<PairedComparison>& family,
                                   GateOn on);

}  // namespace slalom
