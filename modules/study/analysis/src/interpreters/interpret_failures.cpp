// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/failure_taxonomy.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

DataTable exact_table(const FailureTaxonomy& taxonomy, const ResultTable& results) {
  RowTable rows("outcomes_by_" + taxonomy.descriptor.id, "Outcomes by method and bin");
  for (const OutcomeGroup& group : taxonomy.groups) {
    for (const OutcomeFraction& entry : group.outcomes) {
      rows.begin_row();
      rows.add("method", Field{group.method});
      rows.add(taxonomy.descriptor.id + ".low", group.bin.low);
      rows.add(taxonomy.descriptor.id + ".high", group.bin.high);
      rows.add("outcome", Field{entry.outcome});
      rows.add("n", group.n);
      rows.add("count", entry.runs.size());
      rows.add("fraction", group.n > 0 ? std::optional(entry.fraction) : std::nullopt,
               entry.interval);
      rows.add_runs(results, entry.runs);
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
    for (const OutcomeFraction& entry : group.outcomes) rows.add(entry.outcome, entry.runs.size());
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_failures(const std::vector<ResultTable>& results,
                                  const AnalysisQuery& query) {
  Interpretation found;
  for (const BinSpec& spec : query.rows) {
    const FailureTaxonomy taxonomy =
        build_failure_taxonomy(results[0], spec, query.comparison.analysis, query.method);
    found.tables.push_back(exact_table(taxonomy, results[0]));
    found.views.push_back(view_table(taxonomy));
    if (taxonomy.left_out == 0) continue;
    found.remarks.push_back(count_text(taxonomy.left_out, "run") + " left out: " +
                            taxonomy.descriptor.id + " outside the bins or without a value");
  }
  return found;
}

}  // namespace slalom
