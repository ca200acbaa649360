#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/summary.h>

namespace slalom {
namespace {

class SummaryInterpreter : public Interpreter {
 public:
  std::string id() const override { return "summary"; }
  std::string help() const override { return "Say how each method did over all its runs"; }
  std::vector<std::string> default_metrics() const override {
    return {"success", "optimality", "safety"};
  }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    const SummaryTable summary =
        build_summary(results[0], question.metrics, question.comparison.analysis);
    asked_methods(results[0], question.method);
    RowTable exact("summary", "Summary"), view("summary", "All scenarios");
    for (const MethodSummary& method : summary.methods) {
      if (!question.method.empty() && method.method != question.method) continue;
      for (RowTable* rows : {&exact, &view}) {
        rows->begin_row();
        rows->add("method", Field{method.method});
        rows->add("runs", method.n);
        for (const std::string& outcome : summary.outcomes) {
          const auto found = method.outcomes.find(outcome);
          rows->add("outcome." + outcome,
                    found == method.outcomes.end() ? std::size_t{0} : found->second);
        }
      }
      for (std::size_t i = 0; i < summary.columns.size(); ++i) {
        const std::string& metric = summary.columns[i].info.id;
        exact.add_cell(metric, method.cells[i]);
        view.add(metric, method.cells[i].estimate, method.cells[i].interval);
        view.add(metric + ".na", method.cells[i].n - method.cells[i].available);
      }
    }
    return {{exact.table()}, {view.table()}, {}, true};
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_summary_interpreter() {
  return std::make_unique<SummaryInterpreter>();
}

}  // namespace slalom
