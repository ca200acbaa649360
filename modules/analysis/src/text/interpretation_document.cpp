// SPDX-License-Identifier: BSD-3-Clause
#include "view_fields.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>

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
  return "<h2>" + escaped(printable_line(table.title)) + "</h2>\n<table>\n" +
         html_header(view.header) + "<tbody>" + rows + "</tbody>\n</table>\n";
}

constexpr const char* kStyle =
    "@page { size: A4; margin: 12mm; }\n"
    "body { font: 9pt/1.25 sans-serif; color: #111; background: #fff; max-width: 180mm; "
    "margin: 10mm auto; }\n"
    "h1 { font-size: 15pt; } h2 { font-size: 11pt; break-after: avoid; }\n"
    "table { border-collapse: collapse; font-size: 7pt; }\n"
    "th, td { text-align: left; padding: 1px 6px; border-bottom: 1px solid #bbb; "
    "vertical-align: top; }\n"
    "th { border-bottom: 1px solid #111; } tr, li { break-inside: avoid; }\n"
    "ul { padding-left: 5mm; font-size: 7.5pt; }\n"
    "@media print { body { margin: 0; } }\n";

std::string latex_table(const DataTable& table) {
  const ViewFields view = view_fields(table);
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : view.rows) {
    rows.emplace_back();
    for (const std::string& field : row) rows.back().push_back(latex_text(field));
  }
  std::vector<std::string> header;
  for (const std::string& name : view.header) header.push_back(latex_text(name));
  return latex_tabular(latex_text(table.title) + ".", header, rows);
}

}  // namespace

std::string render_latex(const Interpretation& interpretation) {
  std::vector<std::string> tables;
  for (const DataTable& table : views_of(interpretation))
    if (table.rows > 0) tables.push_back(latex_table(table));
  if (!interpretation.footnote.empty() && !tables.empty())
    tables.back() += latex_text(interpretation.footnote) + ".\n";
  return latex_document(tables);
}

std::string render_html(const Interpretation& interpretation, const std::string& title,
                        const FieldAddress& address_of) {
  std::string remarks, tables;
  for (const std::string& remark : interpretation.remarks)
    remarks += "<li>" + escaped(printable_line(remark)) + "</li>\n";
  for (const DataTable& table : views_of(interpretation))
    if (table.rows > 0) tables += html_table(table, address_of);
  const std::string heading = escaped(printable_line(title));
  const std::string footnote = escaped(printable_line(interpretation.footnote));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
         heading + "</title>\n<style>\n" + kStyle + "</style>\n</head>\n<body>\n<h1>" + heading +
         "</h1>\n" + (remarks.empty() ? "" : "<ul>\n" + remarks + "</ul>\n") + tables +
         (footnote.empty() ? "" : "<p>" + footnote + "</p>\n") + "<p>Slalom " + version() +
         "</p>\n</body>\n</html>\n";
}

}  // namespace slalom
