// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/paired_comparison.h>

#include <string>
#include <vector>

namespace slalom {

/// A method in one of the results.
struct HistoryPoint {
  std::size_t result = 0;  ///< index into the results
  Cell cell;
  /// From the preceding result with the method, on the same scenarios; none in the first one, and
  /// without common scenarios.
  std::optional<PairedComparison> change;
};

/// A metric of a method over all results that contain the method.
struct HistoryCurve {
  std::string method;
  Column column;
  std::vector<HistoryPoint> points;
};

/// A run whose success differs from that of the same scenario, method and repetition in the
/// preceding result.
struct ChangedRun {
  std::size_t result = 0, run = 0;  ///< where it is now
  std::string before, now;          ///< outcomes
};

struct History {
  std::vector<HistoryCurve> curves;                     ///< metrics outermost
  std::vector<ChangedRun> new_failures, new_successes;  ///< of the last result
  std::size_t compared_runs = 0;  ///< of the last result, with a partner in the one before
  std::size_t untold_runs = 0;    ///< the same, but without an outcome or success in either
};

/// Results in the order given, such as those of successive versions. All changes are one family of
/// tests. Only `method` if it is given. Throws Error (Usage) for an unknown metric or method.
History build_history(const std::vector<ResultTable>& results,
                      const std::vector<std::string>& metrics, const ComparisonOptions& options,
                      const std::string& method = "");

}  // namespace slalom
