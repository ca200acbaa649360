#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/robustness.h>
#include <slalom/core/error.h>

namespace slalom {
namespace {

DataTable curve_table(const RobustnessTable& table, const RobustnessCurve& curve,
                      const std::vector<RunColumns>& results, bool exact) {
  const std::string& metric = curve.column.info.id;
  RowTable rows(curve.method + "_" + metric,
                curve.method + ": " + metric + " by " + table.parameter);
  for (const RobustnessPoint& point : curve.points) {
    rows.begin_row();
    rows.add(table.parameter, std::optional(point.parameter));
    if (exact) {
      rows.add("source", Field{point.source});
      rows.add_cell(metric, point.cell);
    } else {
      rows.add("n", point.cell.n);
      rows.add(metric, point.cell.estimate, point.cell.interval);
    }
    const auto& change = point.change;
    rows.add("change", change ? change->difference : std::nullopt,
             change ? change->interval : std::nullopt);
    rows.add("p_holm", change ? std::optional(change->adjusted_p) : std::nullopt);
    rows.add("verdict", Field{change ? to_string(change->verdict) : std::string()});
    if (exact) rows.add_runs(results[point.result], point.runs);
  }
  return rows.table();
}

class RobustnessInterpreter : public Interpreter {
 public:
  std::string id() const override { return "robustness"; }
  std::string help() const override {
    return "Follow metrics over a parameter: one result file for each of its values";
  }
  std::size_t fewest_results() const override { return 2; }
  std::size_t most_results() const override { return 1000; }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    if (question.parameter.empty()) {
      throw usage_error("robustness", "no parameter", "--parameter SECTION.KEY");
    }
    RobustnessOptions options{question.comparison, question.values, question.allow_differences};
    const RobustnessTable table =
        build_robustness(results, question.parameter, question.metrics, options);
    if (!question.method.empty()) asked_methods(results[0], question.method);
    Interpretation found;
    for (const RobustnessCurve& curve : table.curves) {
      if (!question.method.empty() && curve.method != question.method) continue;
      found.tables.push_back(curve_table(table, curve, results, true));
      found.views.push_back(curve_table(table, curve, results, false));
      for (const RobustnessPoint& point : curve.points) {
        if (point.change) found.remarks.push_back(verdict_sentence(*point.change));
      }
    }
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_robustness_interpreter() {
  return std::make_unique<RobustnessInterpreter>();
}

}  // namespace slalom
