// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

std::string title_of(const DescriptorMap& map) {
  return map.method + ": " + map.column.info.id + " by " + map.row_descriptor.id + " (down) and " +
         map.column_descriptor.id + " (across)";
}

DataTable exact_table(const DescriptorMap& map, const ResultTable& results) {
  RowTable rows(map.method + "_" + map.column.info.id + "_map", title_of(map));
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    for (std::size_t j = 0; j < map.columns.size(); ++j) {
      rows.begin_row();
      rows.add("method", Field{map.method});
      rows.add(map.row_descriptor.id + ".low", map.rows[i].low);
      rows.add(map.row_descriptor.id + ".high", map.rows[i].high);
      rows.add(map.column_descriptor.id + ".low", map.columns[j].low);
      rows.add(map.column_descriptor.id + ".high", map.columns[j].high);
      rows.add_cell(map.column.info.id, map.fields[i][j].cell);
      rows.add_runs(results, map.fields[i][j].runs);
    }
  }
  return rows.table();
}

DataTable view_table(const DescriptorMap& map) {
  RowTable rows("map", title_of(map));
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    rows.begin_row();
    rows.add(map.row_descriptor.id, Field{map.rows[i].label()});
    for (std::size_t j = 0; j < map.columns.size(); ++j) {
      const Cell& cell = map.fields[i][j].cell;
      const int digits = digits_for({&cell}, map.column);
      const std::string text =
          cell.n == 0 ? "no runs" : value_text(cell, digits) + " " + values_text(cell);
      rows.add(map.columns[j].label(), Field{text});
    }
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_map(const std::vector<ResultTable>& results, const AnalysisQuery& query) {
  if (query.rows.size() != 2) {
    throw usage_error("--map", std::to_string(query.rows.size()) + " entries in --rows",
                      "bins of two descriptors: ID:BINS;ID:BINS");
  }
  Interpretation found;
  for (const std::string& metric : query.metrics) {
    for (const std::string& method : selected_methods(results[0], query.method)) {
      const DescriptorMap map = build_descriptor_map(
          results[0], method, query.rows[0], query.rows[1], metric, query.comparison.analysis);
      found.tables.push_back(exact_table(map, results[0]));
      found.views.push_back(view_table(map));
      if (map.left_out == 0) continue;
      found.remarks.push_back(method + ": " + count_text(map.left_out, "run") +
                              " left out: outside the bins or without a value");
    }
  }
  return found;
}

}  // namespace slalom
