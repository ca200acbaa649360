#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/table_sums.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// Adds the runs of each row, and the medians of its cells.
void add_runs(CrossTable& cross, const ResultTable& table, const RunRows& row_of,
              const AnalysisOptions& options) {
  const std::uint32_t method = index_of_method(table, cross.method);
  for (CrossRow& row : cross.rows) row.runs.reserve(row.n);
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::size_t row = row_of(run);
    if (table.method[run] == method && row < cross.rows.size()) cross.rows[row].runs.push_back(run);
  }
  for (CrossRow& row : cross.rows) {
    if (options.run_ids)
      for (const std::size_t run : row.runs) row.run_ids.push_back(run_id(table, run));
    for (std::size_t i = 0; options.medians && i < row.cells.size(); ++i)
      add_medians(row.cells[i],
                  numbers_of(*find_metric(table, cross.columns[i].info.id), row.runs));
  }
}

}  // namespace

std::uint32_t index_of_method(const ResultTable& table, const std::string& method) {
  const auto found = std::find(table.methods.begin(), table.methods.end(), method);
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
    const RunRows row_of(rows[i], table);
    for (std::size_t m = 0; m < methods; ++m)
      add_runs(tables[i * methods + m], table, row_of, options);
  }
  return tables;
}

}  // namespace slalom
