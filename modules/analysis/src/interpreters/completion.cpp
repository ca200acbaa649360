#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/completion.h>

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
    // The scale log(-log) is one of shares that have not arrived, for Kaplan and Meier's.
    const double share = complement ? 1 - point.value : point.value;
    auto interval = share_interval(share, point.standard_error, confidence);
    if (interval && complement) interval = Interval{1 - interval->high, 1 - interval->low};
    rows.add("arrived", std::optional(point.value), interval);
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
  RowTable rows("completion", "Share of runs that had arrived by then");
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

class CompletionInterpreter : public Interpreter {
 public:
  std::string id() const override { return "completion"; }
  std::string help() const override {
    return "Say how many runs had arrived by when: curves with competing failures";
  }
  std::vector<std::string> default_metrics() const override { return {"time_to_goal"}; }
  std::vector<std::string> further_metrics() const override {
    return {"path_length", "mean_speed"};
  }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    Interpretation found;
    const double confidence = question.comparison.analysis.confidence;
    for (const std::string& metric : question.metrics) {
      const std::vector<CompletionCurve> curves = build_completion(results[0], metric);
      RowTable rows("completion_" + metric, "Completion curves");
      for (const CompletionCurve& curve : curves) {
        add_curve(rows, curve.method, "aalen_johansen", curve.incidence, false, confidence);
        add_curve(rows, curve.method, "kaplan_meier", curve.kaplan_meier, true, confidence);
        found.remarks.push_back(curve.method + ": " + std::to_string(curve.successes) + " of " +
                                count_text(curve.n, "run") + " arrived");
        if (curve.unknown_end == 0) continue;
        found.remarks.push_back(curve.method + ": " + count_text(curve.unknown_end, "failed run") +
                                " of unknown duration, left out of kaplan_meier");
      }
      found.tables.push_back(rows.table());
      found.views.push_back(view_table(curves));
    }
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_completion_interpreter() {
  return std::make_unique<CompletionInterpreter>();
}

}  // namespace slalom
