// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/table_sums.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/results/privileged.h>

#include <algorithm>

namespace slalom {
namespace {

/// Adds the runs of each row, and the medians of its cells, to the tables of the methods.
void add_runs(CrossTable* begin, CrossTable* end, const ResultTable& table, const RunRows& row_of,
              const AnalysisOptions& options) {
  std::vector<CrossTable*> of_method(table.methods.size(), nullptr);
  for (CrossTable* cross = begin; cross != end; ++cross) {
    of_method[index_of_method(table, cross->method)] = cross;
    for (CrossRow& row : cross->rows) row.runs.reserve(row.n);
  }
  for (std::size_t run = 0; run < table.size(); ++run) {
    CrossTable* cross = of_method[table.method[run]];
    const std::size_t row = row_of(run);
    if (cross != nullptr && row < cross->rows.size()) cross->rows[row].runs.push_back(run);
  }
  for (CrossTable* cross = begin; cross != end; ++cross)
    for (CrossRow& row : cross->rows) {
      if (options.run_ids)
        for (const std::size_t run : row.runs) row.run_ids.push_back(run_id(table, run));
      for (std::size_t i = 0; options.medians && i < row.cells.size(); ++i)
        add_medians(row.cells[i], table, row.runs, *find_metric(table, cross->columns[i].info.id),
                    options.confidence);
    }
}

}  // namespace

std::uint32_t index_of_method(const ResultTable& table, const std::string& method) {
  const auto found =
      std::find(table.methods.begin(), table.methods.end(), marked_name(table, method));
  if (found != table.methods.end()) {
    return static_cast<std::uint32_t>(found - table.methods.begin());
  }
  throw usage_error("method", "no runs of '" + method + "' in these results",
                    expected_name(method, table.methods));
}

std::vector<CrossTable> build_cross_tables(const ResultTable& table,
                                           const std::vector<BinSpec>& specs,
                                           const std::vector<std::string>& column_ids,
                                           const AnalysisOptions& options,
                                           const std::string& method) {
  require_valid(options);
  resolve_columns(table, column_ids);  // throws for an unknown one
  if (!method.empty()) index_of_method(table, method);
  std::vector<BinnedRows> rows;
  for (const BinSpec& spec : specs) rows.push_back(bin_rows(spec, table));
  TableSums sums(rows, column_ids, method);
  sums.add(table);
  std::vector<CrossTable> tables = sums.cross_tables(options);
  const std::size_t methods = tables.size() / std::max<std::size_t>(rows.size(), 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CrossTable* const first = tables.data() + i * methods;
    add_runs(first, first + methods, table, RunRows(rows[i], table), options);
  }
  for (CrossTable& cross : tables)
    if (cross.method != unmarked_name(table, cross.method))
      cross.footnote = privileged_footnote(table);
  return tables;
}

}  // namespace slalom
