// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/interpreter.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// An analysis as specified by a user, in text. Empty texts and 0 stand for the defaults.
struct AnalysisRequest {
  std::string rows;                ///< bins, see parse_bin_specs()
  std::string metrics;             ///< ids, comma-separated
  std::string method;              ///< restricts to one method
  std::string baseline;            ///< compare: the reference of all comparisons
  std::string parameter, values;   ///< robustness: "sensor.noise_sigma", "0,0.1"
  bool despite_settings = false;   ///< compare campaigns that differ in other settings
  std::vector<std::string> gates;  ///< compare: "success >= -0.02"
  GateOn gate_on = GateOn::Estimate;
  double confidence = 0;  ///< of intervals
  double relevant = 0;    ///< smallest difference of interest
  double power = 0.8;     ///< statistical power for that difference
};

/// Throws Error (Usage) unless the interpreter takes that many results.
void require_number_of_results(const Interpreter& interpreter, std::size_t results);

/// The ids of the columns that the interpreter reads; none if it reads all, or if the request
/// leaves rows or metrics to the defaults.
std::optional<std::vector<std::string>> requested_columns(const AnalysisRequest& request,
                                                          const Interpreter& interpreter);

/// The request with its defaults: those of [analysis] in the campaign of `results` (its metrics for
/// tables only); then density:q4 (or all) and the interpreter's metrics, as far as the results
/// contain them. Throws Error (Usage) for malformed texts.
AnalysisQuery make_query(const AnalysisRequest& request, const Interpreter& interpreter,
                         const ResultTable& results);

}  // namespace slalom
