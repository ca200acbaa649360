// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/table_latex.h>
#include <slalom/app/statement.h>
#include <slalom/core/text.h>
#include <slalom/io/svg_scene.h>

#include <algorithm>

namespace slalom {
namespace {

std::string text_of(const StatementTable& table) {
  std::vector<std::vector<std::string>> rows = table.rows;
  if (table.header_in_text) rows.insert(rows.begin(), table.header);
  std::vector<std::size_t> widths(table.header.size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text = table.caption.empty() ? "" : table.caption + "\n";
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), ' ');
      line += "  " + (table.alignment[i] == 'r' ? space + row[i] : row[i] + space);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string html_of(const StatementTable& table) {
  const auto row_of = [&](const std::vector<std::string>& row, const std::string& tag) {
    std::string cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += "<" + tag + (table.alignment[i] == 'r' ? " class=\"number\">" : ">") +
               html_escape(row[i]) + "</" + tag + ">";
    return "<tr>" + cells + "</tr>\n";
  };
  std::string html = "<div class=\"scroll\" tabindex=\"0\"><table>\n<caption>" +
                     html_escape(table.caption) + "</caption>\n" + row_of(table.header, "th");
  for (const auto& row : table.rows) html += row_of(row, "td");
  return html + "</table></div>\n";
}

/// Whether a part is the answer to the question, with which a page begins.
bool is_answer(const StatementPart& part) {
  const auto* line = std::get_if<std::string>(&part);
  return std::holds_alternative<StatementFigure>(part) ||
         (line != nullptr && (starts_with(*line, "claim: ") || starts_with(*line, "but ")));
}

std::string html_of(const StatementPart& part) {
  if (const auto* line = std::get_if<std::string>(&part))
    return (is_answer(part) ? "<p class=\"answer\">" : "<p>") + html_escape(*line) + "</p>\n";
  if (const auto* table = std::get_if<StatementTable>(&part)) return html_of(*table);
  return std::get<StatementFigure>(part).svg;
}

constexpr char kStyle[] =
    "body{font:15px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}caption{text-align:left;font-weight:bold}"
    "th,td{padding:.15em .8em;text-align:left;border-bottom:1px solid #ddd}"
    ".number{text-align:right}svg{max-width:100%;height:auto}"
    ".failures{display:flex;flex-wrap:wrap;gap:1em}figure{margin:0;max-width:18em}"
    "p,h1{overflow-wrap:anywhere}h1{font-size:1.5em}.answer{font-size:1.15em;font-weight:bold}"
    ".scroll{overflow-x:auto}td{white-space:nowrap}pre{white-space:pre-wrap;overflow-wrap:anywhere}"
    "@media(prefers-color-scheme:dark){body{background:#14171c;color:#e4e6ea}"
    "th,td{border-color:#444}svg{background:#fff}}";

}  // namespace

std::string render_text(const Statement& statement) {
  std::string text = statement.title + "\n";
  for (const auto& part : statement.parts) {
    if (const auto* line = std::get_if<std::string>(&part)) text += *line + "\n";
    if (const auto* table = std::get_if<StatementTable>(&part)) text += text_of(*table);
  }
  return text;
}

std::string render_latex(const Statement& statement) {
  std::vector<std::string> parts = {latex_text(statement.title) + ".\n"};
  for (const auto& part : statement.parts) {
    if (const auto* line = std::get_if<std::string>(&part))
      parts.push_back(latex_text(*line) + ".\n");
    const auto* table = std::get_if<StatementTable>(&part);
    if (table == nullptr) continue;
    std::vector<std::string> header;
    for (const std::string& name : table->header) header.push_back(latex_text(name));
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table->rows) {
      rows.emplace_back();
      for (const std::string& cell : row) rows.back().push_back(latex_text(cell));
    }
    const std::string& caption = table->caption.empty() ? statement.title : table->caption;
    parts.push_back(latex_tabular(latex_text(caption), caption, header, rows));
  }
  return latex_document({join(parts, "\n")});
}

std::string render_html(const Statement& statement, const std::string& more) {
  const std::string title = html_escape(statement.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<main>\n<h1>" + title +
      "</h1>\n";
  for (const bool answer : {true, false})
    for (const StatementPart& part : statement.parts)
      if (is_answer(part) == answer) html += html_of(part);
  return html + more + "</main>\n</body>\n</html>\n";
}

std::string render_svg(const Statement& statement) {
  std::string svg;
  for (const auto& part : statement.parts)
    if (const auto* figure = std::get_if<StatementFigure>(&part)) svg += figure->svg;
  return svg;
}

}  // namespace slalom
