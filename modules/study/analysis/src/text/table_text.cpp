// SPDX-License-Identifier: BSD-3-Clause
#include "text_grid.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/findings.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/results/privileged.h>
#include <slalom/results/repeatability.h>

namespace slalom {
namespace {

std::string column_header(const Column& column) {
  std::string text = printable_line(column.info.id);
  const std::string arrow = direction_arrow(column.info.direction);
  if (!arrow.empty()) text += " " + arrow;
  if (column.info.unit != "-") text += " " + printable_line(column.info.unit);
  return column.wall_clock ? text + " (wall clock)" : text;
}

std::vector<std::string> headers(const std::string& first, const std::vector<Column>& columns) {
  std::vector<std::string> header = {printable_line(first)};
  for (const Column& column : columns) header.push_back(column_header(column));
  return header;
}

TextGrid::Lines cell_lines(const Cell& cell, const Column& column, int digits) {
  return {value_text(cell, digits), support_text(cell, column, digits)};
}

std::string outcomes_text(const SummaryTable& table) {
  std::vector<std::string> header = {"method", "runs"};
  for (const std::string& outcome : table.outcomes) header.push_back(printable_line(outcome));
  TextGrid grid(header);
  grid.align_right();
  for (const MethodSummary& method : table.methods) {
    std::vector<TextGrid::Lines> row = {{printable_line(method.method)},
                                        {std::to_string(method.n)}};
    for (const std::string& outcome : table.outcomes) {
      const auto found = method.outcomes.find(outcome);
      row.push_back({found == method.outcomes.end() ? "0" : std::to_string(found->second)});
    }
    grid.add_row(std::move(row));
  }
  return grid.text();
}

/// In some row more than a tenth of the runs have no value.
bool has_survivors_only(const CrossTable& table, std::size_t column) {
  for (const CrossRow& row : table.rows)
    if (is_survivors_only(row.cells[column].n, row.cells[column].available)) return true;
  return false;
}

std::string na_lines(const CrossTable& table) {
  std::string text;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string reasons = na_text(table.columns[column], na_of_column(table, column));
    if (reasons.empty()) continue;
    const bool many = has_survivors_only(table, column);
    text += "NA  " + printable_line(reasons) +
            (many ? "; more than 10 %: means not comparable" : "") + "\n";
  }
  return text;
}

/// Names columns with a mean that has no interval, and no median in its place.
std::string interval_notes(const std::vector<Column>& columns,
                           const std::vector<const std::vector<Cell>*>& rows) {
  std::string text;
  for (std::size_t column = 0; column < columns.size(); ++column)
    for (const std::vector<Cell>* cells : rows) {
      const Cell& cell = (*cells)[column];
      if (cell.interval_na.empty() || cell.median_interval) continue;
      text += "NA  interval of a mean of " + printable_line(columns[column].info.id) + ": " +
              cell.interval_na + "\n";
      break;
    }
  return text;
}

std::string confidence_text(double confidence) {
  return percent_text(confidence) + " % intervals";
}

}  // namespace

std::string render_summary_text(const SummaryTable& table) {
  if (table.methods.empty()) return "No runs.\n";
  TextGrid grid(headers("method", table.columns));
  std::vector<int> digits;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::vector<const Cell*> cells;
    for (const MethodSummary& method : table.methods) cells.push_back(&method.cells[column]);
    digits.push_back(digits_for(cells, table.columns[column]));
  }
  std::vector<const std::vector<Cell>*> rows;
  for (const MethodSummary& method : table.methods) {
    rows.push_back(&method.cells);
    std::vector<TextGrid::Lines> row = {{printable_line(method.method)}};
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      row.push_back(cell_lines(method.cells[column], table.columns[column], digits[column]));
    }
    grid.add_row(std::move(row));
  }
  return "Outcomes of all runs\n\n" + outcomes_text(table) + "\nAll scenarios, " +
         confidence_text(table.confidence) + "\n\n" + grid.text() +
         interval_notes(table.columns, rows);
}

std::string render_cross_table_text(const CrossTable& table) {
  std::string text =
      printable_line(table.title) + ", " + confidence_text(table.confidence) + "\n\n";
  TextGrid grid(headers(table.descriptor.id, table.columns));
  for (const CrossRow& row : table.rows) {
    std::vector<TextGrid::Lines> cells = {{row.bin.label(), count_text(row.n, "run")}};
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const int digits = column_digits(table, column);
      cells.push_back(cell_lines(row.cells[column], table.columns[column], digits));
    }
    grid.add_row(std::move(cells));
  }
  std::vector<const std::vector<Cell>*> rows;
  for (const CrossRow& row : table.rows) rows.push_back(&row.cells);
  text += grid.text() + na_lines(table) + interval_notes(table.columns, rows);
  for (const std::string& note : table.notes) text += "Note  " + printable_line(note) + "\n";
  for (const Finding& finding : condensed_findings(table))
    text += "→ " + printable_line(finding.text) + "\n";
  return text;
}

std::string render_tables_text(const ResultTable& table, const std::vector<BinSpec>& rows,
                               const std::vector<std::string>& columns, double confidence) {
  AnalysisOptions options;
  options.run_ids = false;
  options.confidence = confidence;
  Interpretation found;
  found.summary = build_summary(table, columns, options);
  found.cross_tables = build_cross_tables(table, rows, columns, options);
  found.remarks = notes_on_runs(table);
  found.footnote = privileged_footnote(table);
  return render_text(found);
}

}  // namespace slalom
