#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/failure_taxonomy.h>

namespace slalom {
namespace {

DataTable exact_table(const FailureTaxonomy& taxonomy, const RunColumns& results) {
  RowTable rows("outcomes_by_" + taxonomy.descriptor.id, "Outcomes by method and bin");
  for (const OutcomeGroup& group : taxonomy.groups) {
    for (const OutcomeShare& share : group.outcomes) {
      rows.begin_row();
      rows.add("method", Field{group.method});
      rows.add(taxonomy.descriptor.id + ".low", group.bin.low);
      rows.add(taxonomy.descriptor.id + ".high", group.bin.high);
      rows.add("outcome", Field{share.outcome});
      rows.add("n", group.n);
      rows.add("count", share.runs.size());
      rows.add("share", group.n > 0 ? std::optional(share.share) : std::nullopt, share.interval);
      rows.add_runs(results, share.runs);
    }
  }
  return rows.table();
}

DataTable view_table(const FailureTaxonomy& taxonomy) {
  RowTable rows("outcomes", "Outcomes by " + taxonomy.descriptor.id);
  for (const OutcomeGroup& group : taxonomy.groups) {
    rows.begin_row();
    rows.add("method", Field{group.method});
    rows.add(taxonomy.descriptor.id, Field{group.bin.label()});
    rows.add("n", group.n);
    for (const OutcomeShare& share : group.outcomes) rows.add(share.outcome, share.runs.size());
  }
  return rows.table();
}

class FailureInterpreter : public Interpreter {
 public:
  std::string id() const override { return "failures"; }
  std::string help() const override { return "Count outcomes by method and by bin"; }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    Interpretation found;
    for (const BinSpec& spec : question.rows) {
      const FailureTaxonomy taxonomy =
          build_failure_taxonomy(results[0], spec, question.comparison.analysis);
      found.tables.push_back(exact_table(taxonomy, results[0]));
      found.views.push_back(view_table(taxonomy));
      if (taxonomy.left_out == 0) continue;
      found.remarks.push_back(count_text(taxonomy.left_out, "run") + " left out: " +
                              taxonomy.descriptor.id + " outside the bins or without a value");
    }
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_failure_interpreter() {
  return std::make_unique<FailureInterpreter>();
}

}  // namespace slalom
