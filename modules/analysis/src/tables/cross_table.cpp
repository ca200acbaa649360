#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// Assigns the runs of a method to rows, and counts the runs that belong to none.
void assign_runs(CrossTable& cross, const ResultTable& table, std::uint32_t method,
                 const RunValues* values) {
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (table.method[run] != method) continue;
    if (values != nullptr && values->is_na(run)) {
      ++cross.undescribed;
      continue;
    }
    const double value = values != nullptr ? (*values)(run) : 0;
    const auto row = std::find_if(cross.rows.begin(), cross.rows.end(),
                                  [value](const CrossRow& r) { return r.bin.contains(value); });
    if (row == cross.rows.end()) {
      ++cross.outside;
    } else {
      row->runs.push_back(run);
    }
  }
}

void fill_row(CrossRow& row, const CrossTable& cross, const ResultTable& table,
              const AnalysisOptions& options) {
  if (options.run_ids) {
    for (const std::size_t run : row.runs) row.run_ids.push_back(run_id(table, run));
  }
  const std::size_t failures = count_failures(table, row.runs);
  for (const Column& column : cross.columns) {
    const std::string label =
        join({cross.method, cross.descriptor.id, row.bin.label(), column.info.id}, "/");
    row.cells.push_back(
        make_cell(table, row.runs, failures, *find_metric(table, column.info.id), options, label));
  }
}

void add_notes(CrossTable& cross) {
  if (cross.outside > 0) {
    cross.notes.push_back(count_text(cross.outside, "run") + " left out: " + cross.descriptor.id +
                          " outside the bins");
  }
  if (cross.undescribed > 0) {
    cross.notes.push_back(count_text(cross.undescribed, "run") +
                          " left out: scenario has no value of " + cross.descriptor.id);
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

CrossTable build_cross_table(const ResultTable& table, const std::string& method,
                             const BinSpec& spec, const std::vector<Column>& columns,
                             const AnalysisOptions& options) {
  require_valid(options);
  const std::uint32_t index = index_of_method(table, method);
  CrossTable cross;
  cross.method = method;
  cross.columns = columns;
  cross.confidence = options.confidence;
  for (const Bin& bin : make_bins(spec, table)) cross.rows.push_back({bin, {}, {}, {}});
  if (spec.kind == BinSpec::Kind::All) {
    cross.descriptor = {"all", 1, "All scenarios", "-", Direction::None};
    assign_runs(cross, table, index, nullptr);
  } else {
    const RunValues values(table, spec.descriptor);
    cross.descriptor = values.info();
    assign_runs(cross, table, index, &values);
  }
  cross.title = method + " by " + cross.descriptor.id;
  for (CrossRow& row : cross.rows) fill_row(row, cross, table, options);
  add_notes(cross);
  return cross;
}

std::vector<CrossTable> build_cross_tables(const ResultTable& table,
                                           const std::vector<BinSpec>& specs,
                                           const std::vector<std::string>& column_ids,
                                           const AnalysisOptions& options,
                                           const std::string& method) {
  const std::vector<Column> columns = resolve_columns(table, column_ids);
  const std::vector<std::string> methods =
      method.empty() ? table.methods : std::vector<std::string>{method};
  std::vector<CrossTable> tables;
  for (const BinSpec& spec : specs) {
    for (const std::string& name : methods) {
      tables.push_back(build_cross_table(table, name, spec, columns, options));
    }
  }
  return tables;
}

}  // namespace slalom
