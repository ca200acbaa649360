// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/interpreter.h>

namespace slalom {

Interpretation interpret_cross_tables(const std::vector<ResultTable>& results,
                                      const AnalysisQuery& query) {
  const AnalysisOptions& options = query.comparison.analysis;
  Interpretation found;
  if (query.summary && query.method.empty()) {
    found.summary = build_summary(results[0], query.metrics, options);
  }
  found.cross_tables =
      build_cross_tables(results[0], query.rows, query.metrics, options, query.method);
  return found;
}

}  // namespace slalom
