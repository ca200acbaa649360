// SPDX-License-Identifier: BSD-3-Clause
#include "view_fields.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace slalom {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text)
    html += c == '<'   ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '&' ? "&amp;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return html;
}

std::string html_header(const std::vector<std::string>& names) {
  std::string row;
  for (const std::string& name : names) row += "<th>" + escaped(name) + "</th>";
  return "<thead><tr>" + row + "</tr>\n</thead>\n";
}

std::string html_field(const std::string& field, const std::string& address) {
  if (address.empty()) return "<td>" + escaped(field) + "</td>";
  return "<td><a href=\"" + escaped(address) + "\">" + escaped(field) + "</a></td>";
}

std::string html_table(const DataTable& table, const FieldAddress& address_of) {
  const ViewFields view = view_fields(table);
  std::string rows;
  for (const auto& row : view.rows) {
    rows += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      rows += html_field(row[i], address_of ? address_of(view.header[i], row[i]) : "");
    rows += "</tr>\n";
  }
  return "<div class=\"card\" tabindex=\"0\"><h2>" + escaped(printable_line(table.title)) +
         "</h2>\n<table>\n" + html_header(view.header) + "<tbody>" + rows +
         "</tbody>\n</table></div>\n";
}

// The look of the report (modules/study/report/pages/report.css), without its charts and pictures.
constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --ground: #f6f7f9; --card: #fff; --ink: #1b2430; --soft: #5b6776;
  --line: #dfe4ea; --accent: #0b5fa5; }
@media (prefers-color-scheme: dark) { :root { --ground: #12161c; --card: #1b212a; --ink: #e7ecf2;
  --soft: #a4b0be; --line: #303945; --accent: #6cb6ff; } }
body { margin: 0 auto; padding: 2.2rem 1.5rem; max-width: 1280px; box-sizing: border-box;
  background: var(--ground); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.05rem; margin: 0 0 0.6rem; break-after: avoid; overflow-wrap: anywhere; }
a { color: var(--accent); text-decoration: none; } a:hover { text-decoration: underline; }
.card, figure { background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  padding: 1rem 1.1rem; margin: 1rem 0; overflow-x: auto; }
ul.card { padding-left: 2.4rem; }
figure { background: #fff; display: inline-block; max-width: 100%; box-sizing: border-box; }
figure svg { max-width: 100%; height: auto; }
table { border-collapse: separate; border-spacing: 0; font-variant-numeric: tabular-nums;
  font-size: 0.9rem; }
th, td { text-align: left; vertical-align: top; padding: 0.3rem 0.9rem 0.3rem 0;
  border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-weight: 600; border-bottom: 2px solid var(--line); }
tr, li, figure { break-inside: avoid; } p { color: var(--soft); font-size: 0.82rem; }
@page { size: A4; margin: 12mm; }
@media print { body { background: #fff; color: #111; font-size: 9px; max-width: none; padding: 0; }
  .card { padding: 0.3rem 0.5rem; overflow: visible; } }
)css";

std::string latex_table(const DataTable& table) {
  const ViewFields view = view_fields(table);
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : view.rows) {
    rows.emplace_back();
    for (const std::string& field : row) rows.back().push_back(latex_text(field));
  }
  std::vector<std::string> header;
  for (const std::string& name : view.header) header.push_back(latex_text(name));
  return latex_tabular(latex_text(table.title) + ".", table.name, header, rows);
}

std::string markdown_line(const std::vector<std::string>& fields) {
  std::string line = "|";
  for (const std::string& field : fields) {
    line += " ";
    for (const char c : field) line += (c == '|' ? "\\" : "") + std::string(1, c);
    line += " |";
  }
  return line + "\n";
}

std::string markdown_table(const DataTable& table) {
  const ViewFields view = view_fields(table);
  std::string text = "**" + printable_line(table.title) + "**\n\n" + markdown_line(view.header) +
                     markdown_line(std::vector<std::string>(view.header.size(), "---"));
  for (const auto& row : view.rows) text += markdown_line(row);
  return text;
}

/// The cells of a metric in a row, one of each method: their tables have the same bins.
std::vector<const Cell*> cells_of(const std::vector<const CrossTable*>& methods, std::size_t row,
                                  std::size_t column) {
  std::vector<const Cell*> cells;
  for (const CrossTable* method : methods) cells.push_back(&method->rows[row].cells[column]);
  return cells;
}

/// The runs of a method in a row; "5 to 10" if some have more than others.
Field runs_of(const std::vector<const CrossTable*>& methods, std::size_t row) {
  std::size_t least = methods[0]->rows[row].n, most = least;
  for (const CrossTable* method : methods) {
    least = std::min(least, method->rows[row].n);
    most = std::max(most, method->rows[row].n);
  }
  if (least == most) return static_cast<std::int64_t>(most);
  return std::to_string(least) + " to " + std::to_string(most);
}

/// "0.95 [0.94, 0.96]", with the number of values if some are missing.
std::string display_text(const Cell& cell, int digits) {
  return value_text(cell, digits) + (cell.available < cell.n ? " " + values_text(cell) : "");
}

/// The values of one metric, exact or for display.
DataTable by_method(const std::shared_ptr<std::vector<CrossTable>>& tables,
                    const std::vector<const CrossTable*>& methods, std::size_t column,
                    bool display) {
  const CrossTable& first = *methods[0];
  const Column& metric = first.columns[column];
  DataTable table{metric.info.id + "_by_" + first.descriptor.id,
                  metric.info.id + " by " + first.descriptor.id + ", " +
                      percent_text(first.confidence) + " % intervals",
                  {first.descriptor.id, "runs"},
                  first.rows.size(),
                  {}};
  for (const CrossTable* method : methods) {
    table.columns.push_back(method->method);
    if (display) continue;
    table.columns.push_back(method->method + ".low");
    table.columns.push_back(method->method + ".high");
  }
  const std::size_t parts = display ? 1 : 3;
  table.at = [tables, methods, column, display, parts, metric](std::size_t row,
                                                               std::size_t i) -> Field {
    if (i == 0) return methods[0]->rows[row].bin.label();
    if (i == 1) return runs_of(methods, row);
    const auto cells = cells_of(methods, row, column);
    const Cell& cell = *cells[(i - 2) / parts];
    if (display) return display_text(cell, digits_for(cells, metric));
    const std::optional<Interval>& interval = stated_interval(cell);
    const std::size_t part = (i - 2) % parts;
    const std::optional<double>& value = cell.median_interval ? cell.median : cell.estimate;
    if (part == 0) return value ? Field{*value} : Field{};
    if (!interval) return Field{};
    return part == 1 ? interval->low : interval->high;
  };
  return table;
}

}  // namespace

std::string render_latex(const Interpretation& interpretation) {
  std::vector<std::string> tables;
  for (const DataTable& table : views_of(interpretation))
    if (table.rows > 0) tables.push_back(latex_table(table));
  if (!interpretation.footnote.empty() && !tables.empty())
    tables.back() += latex_text(interpretation.footnote) + ".\n";
  std::set<std::string> used;
  return number_labels(join(tables, "\n"), used);
}

std::string render_markdown(const Interpretation& interpretation) {
  std::vector<std::string> tables;
  for (const DataTable& table : views_of(interpretation))
    if (table.rows > 0) tables.push_back(markdown_table(table));
  if (!interpretation.footnote.empty()) tables.push_back(interpretation.footnote + ".\n");
  return join(tables, "\n");
}

void put_methods_in_columns(Interpretation& interpretation) {
  if (!interpretation.cross_tables) return;
  const auto tables =
      std::make_shared<std::vector<CrossTable>>(std::move(*interpretation.cross_tables));
  interpretation.cross_tables = std::nullopt;
  interpretation.summary = std::nullopt;
  // The tables of the same bins: those of a method come in the order of the rows.
  std::map<std::string, std::size_t> known;
  std::vector<std::vector<const CrossTable*>> groups;
  for (const CrossTable& table : *tables) {
    const std::size_t index = known[table.method]++;
    groups.resize(std::max(groups.size(), index + 1));
    groups[index].push_back(&table);
  }
  for (const auto& methods : groups) {
    for (std::size_t column = 0; column < methods[0]->columns.size(); ++column) {
      interpretation.tables.push_back(by_method(tables, methods, column, false));
      interpretation.views.push_back(by_method(tables, methods, column, true));
    }
  }
}

std::string render_html(const Interpretation& interpretation, const std::string& title,
                        const FieldAddress& address_of, const std::vector<std::string>& figures) {
  std::string remarks, tables;
  for (const std::string& figure : figures) tables += "<figure>" + figure + "</figure>\n";
  for (const std::string& remark : interpretation.remarks)
    remarks += "<li>" + escaped(printable_line(remark)) + "</li>\n";
  for (const DataTable& table : views_of(interpretation))
    if (table.rows > 0) tables += html_table(table, address_of);
  const std::string heading = escaped(printable_line(title));
  const std::string footnote = escaped(printable_line(interpretation.footnote));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
         "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         heading + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<main>\n<h1>" +
         heading + "</h1>\n" +
         (remarks.empty() ? "" : "<ul class=\"card\">\n" + remarks + "</ul>\n") + tables +
         (footnote.empty() ? "" : "<p>" + footnote + "</p>\n") + "<p>Slalom " + version() +
         "</p>\n</main>\n</body>\n</html>\n";
}

}  // namespace slalom
