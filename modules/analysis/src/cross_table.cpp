#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

void require_known_method(const ResultTable& table, const std::string& method) {
  const std::vector<std::string> names = method_names(table);
  if (std::find(names.begin(), names.end(), method) != names.end()) return;
  const std::string nearest = nearest_name(method, names);
  throw usage_error("method", "no runs of '" + method + "' in these results",
                    nearest.empty() ? "one of " + join(names, ", ") : "'" + nearest + "'");
}

QuantityInfo descriptor_info(const ResultTable& table, const BinSpec& spec) {
  if (spec.kind == BinSpec::Kind::All) return {"all", 1, "All scenarios", "-", Direction::None};
  const auto known = table.quantities.find(spec.descriptor);
  if (known != table.quantities.end()) return known->second;
  return {spec.descriptor, 1, spec.descriptor, "-", Direction::None};
}

Value descriptor_of(const ResultTable& table, const RunRecord& run, const std::string& id) {
  const auto scenario = table.scenarios.find(run.scenario_hash);
  if (scenario == table.scenarios.end()) return Value::na("unknown scenario");
  const auto found = scenario->second.descriptors.find(id);
  if (found == scenario->second.descriptors.end()) return Value::na("not computed");
  return found->second.value;
}

/// Puts a run into the row it belongs to, or counts why it belongs to none.
void sort_into_row(CrossTable& cross, const ResultTable& table, std::size_t run, bool all) {
  const Value value =
      all ? Value::of(0) : descriptor_of(table, table.runs[run], cross.descriptor.id);
  if (value.is_na()) {
    ++cross.undescribed;
    return;
  }
  for (CrossRow& row : cross.rows) {
    if (!row.bin.contains(value.number())) continue;
    row.runs.push_back(run);
    row.run_ids.push_back(run_id(table.runs[run]));
    return;
  }
  ++cross.outside;
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

CrossTable build_cross_table(const ResultTable& table, const std::string& method,
                             const BinSpec& spec, const std::vector<Column>& columns,
                             const AnalysisOptions& options) {
  require_valid(options);
  require_known_method(table, method);
  CrossTable cross;
  cross.method = method;
  cross.descriptor = descriptor_info(table, spec);
  cross.title = method + " by " + cross.descriptor.id;
  cross.columns = columns;
  cross.confidence = options.confidence;
  for (const Bin& bin : make_bins(spec, table)) cross.rows.push_back({bin, {}, {}, {}});
  for (std::size_t run = 0; run < table.runs.size(); ++run) {
    if (table.runs[run].method != method) continue;
    sort_into_row(cross, table, run, spec.kind == BinSpec::Kind::All);
  }
  for (CrossRow& row : cross.rows) {
    for (const Column& column : columns) {
      const std::string label =
          join({method, cross.descriptor.id, row.bin.label(), column.info.id}, "/");
      row.cells.push_back(make_cell(table, row.runs, column, options, label));
    }
  }
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
      method.empty() ? method_names(table) : std::vector<std::string>{method};
  std::vector<CrossTable> tables;
  for (const BinSpec& spec : specs) {
    for (const std::string& name : methods) {
      tables.push_back(build_cross_table(table, name, spec, columns, options));
    }
  }
  return tables;
}

}  // namespace slalom
