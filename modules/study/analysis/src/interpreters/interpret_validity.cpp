// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/validity.h>
#include <slalom/core/error.h>

namespace slalom {
namespace {

DataTable validity_table(const ValidityTable& validity, const std::string& method) {
  RowTable rows("validity", "Rank correlation of descriptors with metrics (Spearman)");
  for (const DescriptorValidity& entry : validity.validity) {
    if (!method.empty() && entry.method != method) continue;
    rows.begin_row();
    rows.add("method", Field{entry.method});
    rows.add("metric", Field{entry.metric});
    rows.add("descriptor", Field{entry.descriptor});
    rows.add("scenarios", entry.correlation.n);
    rows.add("rho", entry.correlation.rho, entry.correlation.interval);
  }
  return rows.table();
}

DataTable redundancy_table(const ValidityTable& validity) {
  RowTable rows("redundancy", "Rank correlation of descriptors with each other (Spearman)");
  for (const DescriptorRedundancy& entry : validity.redundancy) {
    rows.begin_row();
    rows.add("first", Field{entry.first});
    rows.add("second", Field{entry.second});
    rows.add("scenarios", entry.correlation.n);
    rows.add("rho", entry.correlation.rho, entry.correlation.interval);
  }
  return rows.table();
}

/// The lower triangle of the symmetric matrix, for display.
DataTable redundancy_matrix(const ValidityTable& validity) {
  const std::size_t n = validity.descriptors.size();
  std::vector<std::vector<std::optional<double>>> rho(n, std::vector<std::optional<double>>(n));
  std::size_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) rho[j][i] = validity.redundancy[next++].correlation.rho;
  }
  RowTable rows("redundancy", "Rank correlation of descriptors with each other (Spearman)");
  for (std::size_t i = 0; i < n; ++i) {
    rows.begin_row();
    rows.add("descriptor", Field{validity.descriptors[i]});
    for (std::size_t j = 0; j < n; ++j) rows.add(validity.descriptors[j], rho[i][j]);
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_validity(const std::vector<ResultTable>& results,
                                  const AnalysisQuery& query) {
  if (results[0].descriptors.empty()) {
    throw usage_error("--validity", "no descriptors in these results",
                      "results with scenario descriptors");
  }
  selected_methods(results[0], query.method);
  const ValidityTable validity =
      build_validity(results[0], query.metrics, query.comparison.analysis);
  const DataTable outcomes = validity_table(validity, query.method);
  return {
      {outcomes, redundancy_table(validity)}, {outcomes, redundancy_matrix(validity)}, {}, true};
}

}  // namespace slalom
