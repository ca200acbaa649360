// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/core/text.h>

#include <cctype>
#include <map>

namespace slalom {
namespace {

std::string latex_column_header(const Column& column) {
  std::string text = latex_text(column.info.id);
  if (column.info.direction == Direction::Up) text += " $\\uparrow$";
  if (column.info.direction == Direction::Down) text += " $\\downarrow$";
  return column.info.unit == "-" ? text : text + " (" + latex_text(column.info.unit) + ")";
}

/// "0.95 [0.94, 0.96]"; if values are missing, also the numbers of values and of missing ones.
std::string cell_latex(const Cell& cell, int digits) {
  std::string text = latex_text(estimate_text(cell, digits));
  const std::string interval = interval_text(cell, digits);
  if (!interval.empty()) text += " {\\small " + interval + "}";
  if (cell.available < cell.n) text += " {\\footnotesize " + values_text(cell) + "}";
  return text;
}

std::string line_of(const std::vector<std::string>& fields) {
  return join(fields, " & ") + " \\\\\n";
}

std::vector<std::string> headers(std::vector<std::string> first,
                                 const std::vector<Column>& columns) {
  for (const Column& column : columns) first.push_back(latex_column_header(column));
  return first;
}

std::string latex_footnote(const std::string& footnote) {
  return footnote.empty() ? "" : " " + latex_text(footnote) + ".";
}

std::string label_of(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  return name;
}

std::string latex_confidence_text(double confidence) {
  return percent_text(confidence) + "\\,\\% intervals in brackets";
}

}  // namespace

std::string latex_tabular(const std::string& caption, const std::string& name,
                          const std::vector<std::string>& header,
                          const std::vector<std::vector<std::string>>& rows) {
  std::string text = "\\begin{table}\n\\centering\n\\caption{" + caption +
                     "}\n\\label{tab:" + label_of(name) + "}\n\\begin{tabular}{l" +
                     std::string(header.size() - 1, 'r') + "}\n\\toprule\n" + line_of(header) +
                     "\\midrule\n";
  for (const auto& row : rows) text += line_of(row);
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string render_latex(const SummaryTable& table) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodSummary& method : table.methods) {
    std::vector<std::string> row = {latex_text(method.method), std::to_string(method.n)};
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      std::vector<const Cell*> cells;
      for (const MethodSummary& other : table.methods) cells.push_back(&other.cells[column]);
      row.push_back(cell_latex(method.cells[column], digits_for(cells, table.columns[column])));
    }
    rows.push_back(std::move(row));
  }
  return latex_tabular("All scenarios; " + latex_confidence_text(table.confidence) + "." +
                           latex_footnote(table.footnote),
                       "summary", headers({"method", "runs"}, table.columns), rows);
}

std::string render_latex(const CrossTable& table) {
  std::vector<std::vector<std::string>> rows;
  for (const CrossRow& line : table.rows) {
    std::vector<std::string> row = {latex_text(line.bin.label()), std::to_string(line.n)};
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      row.push_back(cell_latex(line.cells[column], column_digits(table, column)));
    rows.push_back(std::move(row));
  }
  return latex_tabular(latex_text(table.title) + "; " + latex_confidence_text(table.confidence) +
                           "." + latex_footnote(table.footnote),
                       table.title,
                       headers({latex_text(table.descriptor.id), "runs"}, table.columns), rows);
}

std::string number_labels(const std::string& text, std::set<std::string>& used) {
  const std::string label = "\\label{";
  std::string numbered;
  std::size_t from = 0;
  for (std::size_t at = text.find(label); at != std::string::npos; at = text.find(label, from)) {
    const std::size_t begin = at + label.size(), end = text.find('}', begin);
    numbered +=
        text.substr(from, begin - from) + unused_name(text.substr(begin, end - begin), used);
    from = end;
  }
  return numbered + text.substr(from);
}

std::string latex_document(const std::vector<std::string>& tables) {
  std::set<std::string> used;
  return "\\documentclass{article}\n\\IfFileExists{booktabs.sty}{\\usepackage{booktabs}}{"
         "\\let\\toprule\\hline\\let\\midrule\\hline\\let\\bottomrule\\hline}\n"
         "\\begin{document}\n" +
         number_labels(join(tables, "\n\\clearpage\n"), used) + "\\end{document}\n";
}

std::string latex_text(const std::string& text) {
  static const std::map<char, std::string> special = {
      {'\\', "\\textbackslash{}"},
      {'~', "\\textasciitilde{}"},
      {'^', "\\textasciicircum{}"},
      {'<', "$<$"},
      {'>', "$>$"},
      {'|', "$|$"},
      {'[', "{[}"},  // at the start of a row it would be an argument of the preceding row end
      {'&', "\\&"},
      {'%', "\\%"},
      {'$', "\\$"},
      {'#', "\\#"},
      {'_', "\\_"},
      {'{', "\\{"},
      {'}', "\\}"}};
  const std::string no_glyph = "\x90\x9E\xB0\xBE";  // Icelandic letters from U+00C0 to U+00FF
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_latin =
        byte == 0xC3 && i + 1 < text.size() && no_glyph.find(text[i + 1]) == std::string::npos;
    if (const auto found = special.find(text[i]); found != special.end())
      escaped += found->second;
    else if (is_latin)
      escaped.append(text, i++, 2);
    else if (byte >= ' ' && byte < 0x7F)
      escaped += text[i];
    else if (byte >= 0xC0)
      escaped += '?';
  }
  return escaped;
}

}  // namespace slalom
