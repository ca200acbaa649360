// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/completion.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr int kTimesShown = 8;

void add_curve(RowTable& rows, const std::string& method, const std::string& estimator,
               const std::vector<CurvePoint>& curve, bool complement, double confidence) {
  for (const CurvePoint& point : curve) {
    rows.begin_row();
    rows.add("method", Field{method});
    rows.add("estimator", Field{estimator});
    rows.add("time", std::optional(point.time));
    rows.add("at_risk", point.at_risk);
    // For Kaplan-Meier, the log(-log) scale applies to the fraction that has not reached the goal.
    const double fraction = complement ? 1 - point.value : point.value;
    auto interval = log_log_interval(fraction, point.standard_error, confidence);
    if (interval && complement) interval = Interval{1 - interval->high, 1 - interval->low};
    rows.add("completed", std::optional(point.value), interval);
    rows.add("standard_error", std::optional(point.standard_error));
  }
}

double value_at(const std::vector<CurvePoint>& curve, double time) {
  double value = 0;
  for (const CurvePoint& point : curve) {
    if (point.time <= time) value = point.value;
  }
  return value;
}

DataTable view_table(const std::vector<CompletionCurve>& curves) {
  double latest = 0;
  for (const CompletionCurve& curve : curves) {
    if (!curve.incidence.empty()) latest = std::max(latest, curve.incidence.back().time);
  }
  RowTable rows("completion", "Fraction of runs that reached the goal by this time");
  for (int i = 1; i <= kTimesShown; ++i) {
    const double time = latest * i / kTimesShown;
    rows.begin_row();
    rows.add("time", std::optional(time));
    for (const CompletionCurve& curve : curves) {
      rows.add(curve.method, std::optional(value_at(curve.incidence, time)));
    }
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_completion(const std::vector<ResultTable>& results,
                                    const AnalysisQuery& query) {
  selected_methods(results[0], query.method);
  Interpretation found;
  const double confidence = query.comparison.analysis.confidence;
  for (const std::string& metric : query.metrics) {
    const std::vector<CompletionCurve> curves =
        of_method(build_completion(results[0], metric), query.method);
    RowTable rows("completion_" + metric, "Completion curves");
    for (const CompletionCurve& curve : curves) {
      add_curve(rows, curve.method, "aalen_johansen", curve.incidence, false, confidence);
      add_curve(rows, curve.method, "kaplan_meier", curve.kaplan_meier, true, confidence);
      found.remarks.push_back(curve.method + ": " + std::to_string(curve.successes) + " of " +
                              count_text(curve.n, "run") + " reached the goal");
      if (curve.untimed > 0)
        found.remarks.push_back(curve.method + ": " + count_text(curve.untimed, "run") +
                                " without a time, left out, also reached the goal");
      if (curve.unknown_end == 0) continue;
      found.remarks.push_back(curve.method + ": " + count_text(curve.unknown_end, "failed run") +
                              " of unknown duration, left out of kaplan_meier");
    }
    found.tables.push_back(rows.table());
    found.views.push_back(view_table(curves));
  }
  return found;
}

}  // namespace slalom
