// SPDX-License-Identifier: BSD-3-Clause
#include "index_page.h"
#include "markup.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/results/privileged.h>
#include <slalom/results/repeatability.h>

namespace slalom {
namespace {

Markup element(const std::string& name, const std::vector<Markup>& children,
               const std::string& classes = "") {
  return Markup::element(name, children, classes);
}

std::string number_of_runs(const ReportInput& input) {
  const std::size_t runs = input.runs.size(), planned = input.options.planned_runs;
  return std::to_string(runs) + (runs < planned ? " of " + std::to_string(planned) : "");
}

std::string counts_text(const ReportInput& input) {
  const ResultTable& runs = input.runs;
  return count_text(runs.methods.size(), "method") + ", " +
         count_text(runs.scenario_hashes.size(), "scenario") + ", " + number_of_runs(input) +
         " runs";
}

Markup header_row(const std::vector<std::string>& first, const std::vector<Column>& columns) {
  std::vector<Markup> cells;
  for (const std::string& name : first) cells.push_back(element("th", {name}));
  for (const Column& column : columns) {
    const std::string unit = column.info.unit == "-" ? "" : " [" + column.info.unit + "]";
    cells.push_back(
        element("th", {column.info.id + " " + direction_arrow(column.info.direction) + unit}));
  }
  return element("thead", {element("tr", cells)});
}

Markup cell_markup(const Cell& cell, const Column& column, int digits) {
  return element(
      "td", {element("b", {estimate_text(cell, digits)}), " ", interval_text(cell, digits) + " ",
             element("span", {support_text(cell, column, digits)}, "support")});
}

Markup table_card(const Markup& header, const std::vector<Markup>& rows) {
  return element("div", {element("table", {header, element("tbody", rows)})}, "card");
}

Markup summary_table(const SummaryTable& summary) {
  std::vector<Markup> rows;
  for (const MethodSummary& method : summary.methods) {
    std::string outcomes;
    for (const auto& [outcome, n] : method.outcomes)
      outcomes += (outcomes.empty() ? "" : ", ") + outcome + " " + std::to_string(n);
    std::vector<Markup> cells = {element("th", {method.method}),
                                 element("td", {std::to_string(method.n)}),
                                 element("td", {outcomes})};
    for (std::size_t column = 0; column < summary.columns.size(); ++column) {
      std::vector<const Cell*> all;
      for (const MethodSummary& other : summary.methods) all.push_back(&other.cells[column]);
      cells.push_back(cell_markup(method.cells[column], summary.columns[column],
                                  digits_for(all, summary.columns[column])));
    }
    rows.push_back(element("tr", cells));
  }
  return table_card(header_row({"Method", "Runs", "Outcomes"}, summary.columns), rows);
}

Markup cross_table(const CrossTable& cross) {
  std::vector<Markup> rows;
  for (const CrossRow& row : cross.rows) {
    std::vector<Markup> cells = {element("th", {row.bin.label()}),
                                 element("td", {count_text(row.n, "run")})};
    for (std::size_t column = 0; column < cross.columns.size(); ++column)
      cells.push_back(
          cell_markup(row.cells[column], cross.columns[column], column_digits(cross, column)));
    rows.push_back(element("tr", cells));
  }
  return element("section",
                 {element("h3", {cross.title}),
                  table_card(header_row({cross.descriptor.id, "Runs"}, cross.columns), rows)});
}

Markup all_tables(const ReportInput& input) {
  SummaryTable summary = input.summary;
  if (input.is_selected()) summary.columns.clear();
  std::vector<Markup> parts = {element("h2", {"Summary"}), summary_table(summary)};
  if (!input.tables.empty()) parts.push_back(element("h2", {"Cross tables"}));
  for (const std::vector<CrossTable>& group : input.tables)
    for (const CrossTable& cross : group) parts.push_back(cross_table(cross));
  if (!summary.footnote.empty()) parts.push_back(element("p", {summary.footnote}));
  for (const std::string& note : notes_on_runs(input.runs)) parts.push_back(element("p", {note}));
  return element("div", parts);
}

}  // namespace

std::string index_page(const std::string& page, const ReportInput& input,
                       const Leaderboard& leaderboard, const std::vector<std::string>& headlines) {
  std::vector<Markup> lines;
  for (const std::string& line : headlines)
    lines.push_back(
        element("p", {element("strong", {line + (ends_with(line, "?") ? "" : ".")})}, "headline"));
  return fill_page(page, {{"campaign", campaign_name(input.runs.manifest)},
                          {"counts", counts_text(input)},
                          {"answer", leaderboard.answer()},
                          {"certainty", leaderboard.certainty()},
                          {"headlines", element("div", lines)},
                          {"board", leaderboard.table()},
                          {"differences", leaderboard.differences()},
                          {"next", leaderboard.next_steps()},
                          {"tables", all_tables(input)},
                          {"version", version()}});
}

}  // namespace slalom
