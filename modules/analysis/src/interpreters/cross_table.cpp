#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>

namespace slalom {
namespace {

void add_rows(RowTable& exact, RowTable& view, const CrossTable& cross, const RunColumns& table) {
  for (const CrossRow& row : cross.rows) {
    for (RowTable* rows : {&exact, &view}) {
      rows->begin_row();
      rows->add(cross.descriptor.id, Field{row.bin.label()});
    }
    exact.add("bin.low", row.bin.low);
    exact.add("bin.high", row.bin.high);
    view.add("n", row.runs.size());
    for (std::size_t i = 0; i < cross.columns.size(); ++i) {
      const std::string& metric = cross.columns[i].info.id;
      exact.add_cell(metric, row.cells[i]);
      view.add(metric, row.cells[i].estimate, row.cells[i].interval);
      view.add(metric + ".na", row.cells[i].n - row.cells[i].available);
    }
    exact.add_runs(table, row.runs);
  }
}

class CrossTableInterpreter : public Interpreter {
 public:
  std::string id() const override { return "table"; }
  std::string help() const override {
    return "Print a summary per method and cross tables of bins by metrics";
  }
  std::vector<std::string> default_metrics() const override {
    return {"success", "optimality", "safety"};
  }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    AnalysisOptions options = question.comparison.analysis;
    options.run_ids = false;
    Interpretation found;
    for (const CrossTable& cross : build_cross_tables(results[0], question.rows, question.metrics,
                                                      options, question.method)) {
      RowTable exact(cross.method + "_by_" + cross.descriptor.id, cross.title);
      RowTable view = exact;
      add_rows(exact, view, cross, results[0]);
      found.tables.push_back(exact.table());
      found.views.push_back(view.table());
      for (const std::string& note : cross.notes)
        found.remarks.push_back(cross.title + ": " + note);
      for (const Finding& finding : condensed_findings(cross))
        found.remarks.push_back(finding.text);
    }
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_cross_table_interpreter() {
  return std::make_unique<CrossTableInterpreter>();
}

}  // namespace slalom
