// SPDX-License-Identifier: BSD-3-Clause
#include "../comparison/scenario_means.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

void require_descriptor(const BinSpec& spec) {
  if (spec.kind != BinSpec::Kind::All) return;
  throw usage_error("--map", "'all' is not a descriptor", "bins of two descriptors");
}

void assign_runs(DescriptorMap& map, const ResultTable& table) {
  const std::uint32_t method = index_of_method(table, map.method);
  const RunValues rows(table, map.row_descriptor.id), columns(table, map.column_descriptor.id);
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (table.method[run] != method) continue;
    const bool described = !rows.is_na(run) && !columns.is_na(run);
    const std::size_t i = described ? bin_of(map.rows, rows(run)) : map.rows.size();
    const std::size_t j = described ? bin_of(map.columns, columns(run)) : map.columns.size();
    if (i == map.rows.size() || j == map.columns.size()) {
      ++map.left_out;
    } else {
      map.fields[i][j].runs.push_back(run);
    }
  }
}

}  // namespace

std::size_t bin_of(const std::vector<Bin>& bins, double value) {
  const auto found = std::find_if(bins.begin(), bins.end(),
                                  [value](const Bin& bin) { return bin.contains(value); });
  return static_cast<std::size_t>(found - bins.begin());
}

DescriptorMap build_descriptor_map(const ResultTable& table, const std::string& method,
                                   const BinSpec& rows, const BinSpec& columns,
                                   const std::string& metric, const AnalysisOptions& options) {
  require_valid(options);
  require_descriptor(rows);
  require_descriptor(columns);
  DescriptorMap map;
  map.method = method;
  map.confidence = options.confidence;
  map.column = resolve_columns(table, {metric})[0];
  map.row_descriptor = RunValues(table, rows.descriptor).info();
  map.column_descriptor = RunValues(table, columns.descriptor).info();
  map.rows = make_bins(rows, table);
  map.columns = make_bins(columns, table);
  map.fields.assign(map.rows.size(), std::vector<MapField>(map.columns.size()));
  assign_runs(map, table);
  const ValueColumn& values = require_metric(table, metric);
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    for (std::size_t j = 0; j < map.columns.size(); ++j) {
      MapField& field = map.fields[i][j];
      field.cell = make_cell(table, field.runs, values, options);
    }
  }
  return map;
}

}  // namespace slalom
