#include "html_method_page.h"
#include "html_tables.h"
#include "html_text.h"
#include "run_pages.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kMostRunsListed = 20;

/// Cells with fewer values get neither shade nor whisker: single runs would set the column's scale.
bool enough_to_draw(const Cell& cell) {
  return cell.available >= 5 && cell.interval.has_value();
}

/// What the cells of one column have in common.
struct ColumnScale {
  Column column;
  int digits = 2;
  double low = 0, high = 1;                      ///< of whiskers
  double least_estimate = 0, most_estimate = 1;  ///< of shades

  /// 0 at the worst estimate of the column, 1 at the best; a rate is on its own scale already.
  double goodness(double estimate) const {
    if (column.rate) return estimate;
    if (most_estimate <= least_estimate) return 0.5;
    const double share = (estimate - least_estimate) / (most_estimate - least_estimate);
    return column.info.direction == Direction::Down ? 1 - share : share;
  }
};

ColumnScale make_scale(const Column& column, const std::vector<const Cell*>& cells) {
  ColumnScale scale{column, digits_for(cells, column)};
  if (column.rate) return scale;
  bool first = true;
  for (const Cell* cell : cells) {
    if (!enough_to_draw(*cell)) continue;
    const double estimate = *cell->estimate;
    scale.low = first ? cell->interval->low : std::min(scale.low, cell->interval->low);
    scale.high = first ? cell->interval->high : std::max(scale.high, cell->interval->high);
    scale.least_estimate = first ? estimate : std::min(scale.least_estimate, estimate);
    scale.most_estimate = first ? estimate : std::max(scale.most_estimate, estimate);
    first = false;
  }
  return scale;
}

/// The estimate as a dot on its interval, on the column's scale.
std::string whisker(const Cell& cell, const ColumnScale& scale) {
  if (!enough_to_draw(cell) || scale.high <= scale.low) return "";
  const auto place = [&](double value) {
    return format_fixed(4 + 112 * (value - scale.low) / (scale.high - scale.low), 1);
  };
  return "<svg class=\"whisker\" viewBox=\"0 0 120 9\" preserveAspectRatio=\"xMinYMid\" "
         "aria-hidden=\"true\"><line class=\"axis\" x1=\"4\" x2=\"116\" y1=\"4.5\" y2=\"4.5\"/>"
         "<line x1=\"" +
         place(cell.interval->low) + "\" x2=\"" + place(cell.interval->high) +
         "\" y1=\"4.5\" y2=\"4.5\"/><circle cx=\"" + place(*cell.estimate) +
         "\" cy=\"4.5\" r=\"3\"/></svg>";
}

/// `runs`: the page that lists the cell's runs.
std::string cell_html(const Cell& cell, const ColumnScale& scale, const std::string& runs) {
  const std::string reasons = html_escape(na_text(scale.column, cell.na));
  const std::string title = reasons.empty() ? "" : " title=\"missing: " + reasons + "\"";
  const std::string support =
      html_element("span", "support", html_escape(support_text(cell, scale.column, scale.digits)));
  if (!cell.estimate) {
    return "<td class=\"cell na\"" + title + ">–" + support + "</td>";
  }
  std::string style;
  if (scale.column.info.direction != Direction::None && enough_to_draw(cell)) {
    style = " style=\"--g:" + format_fixed(scale.goodness(*cell.estimate), 2) + "\"";
  }
  return "<td class=\"cell\"" + style + title + ">" + "<a class=\"big\" href=\"" + runs + "\">" +
         estimate_text(cell, scale.digits) + "</a>" +
         html_element("span", "interval", interval_text(cell, scale.digits)) +
         whisker(cell, scale) + support + "</td>";
}

std::string header_cell(const Column& column) {
  const QuantityInfo& info = column.info;
  std::string text = html_escape(info.name) + " " + direction_arrow(info.direction);
  if (info.unit != "-") text += " [" + html_escape(info.unit) + "]";
  text += "<br><code>" + html_escape(info.id) + "</code>";
  return html_element("th", "", column.wall_clock ? text + "<br>wall clock" : text);
}

std::string header_row(const std::vector<std::string>& first, const std::vector<Column>& columns) {
  std::string cells;
  for (const std::string& name : first) cells += html_element("th", "", html_escape(name));
  for (const Column& column : columns) cells += header_cell(column);
  return "<thead><tr>" + cells + "</tr></thead>\n";
}

std::string outcome_cell(const MethodSummary& method, const std::vector<std::string>& outcomes) {
  std::string bar, chips;
  for (const std::string& outcome : outcomes) {
    const auto found = method.outcomes.find(outcome);
    if (found == method.outcomes.end()) continue;
    const std::string n = std::to_string(found->second);
    bar += "<i class=\"" + outcome_class(outcome) + "\" style=\"flex:" + n + "\" title=\"" +
           html_escape(outcome) + " " + n + "\"></i>";
    chips += outcome_chip(outcome, found->second);
  }
  return "<td>" + html_element("div", "bar", bar) + chips + "</td>";
}

/// A few of the runs, and the way to all of them.
std::string runs_list(const CrossRow& row, const ResultTable& results, const std::string& all) {
  std::string items;
  const std::size_t shown = std::min(row.runs.size(), kMostRunsListed);
  for (std::size_t i = 0; i < shown; ++i) {
    const RunRecord& run = results.runs[row.runs[i]];
    items += "<li><a href=\"" + html_escape(run_link(run)) + "\">" +
             html_escape(run.scenario_name) + " #" + std::to_string(run.repetition) + "</a> " +
             outcome_chip(run.outcome) + "</li>\n";
  }
  if (shown < row.runs.size())
    items += "<li><a href=\"" + all + "\">all " + count_text(row.runs.size(), "run") + "</a></li>";
  return "<details class=\"runs\"><summary>" + count_text(row.runs.size(), "run") +
         "</summary><ul class=\"plain\">" + items + "</ul></details>";
}

std::string na_html(const CrossTable& table) {
  std::string lines;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string reasons = na_text(table.columns[column], na_of_column(table, column));
    if (!reasons.empty()) lines += (lines.empty() ? "" : " · ") + html_escape(reasons);
  }
  std::string html;
  if (!lines.empty()) html += html_element("p", "support", "Not available: " + lines);
  for (const std::string& note : table.notes)
    html += html_element("p", "support", html_escape(note));
  return html;
}

std::string cross_table_html(const CrossTable& table, const std::vector<ColumnScale>& scales,
                             const std::string& heading, const ResultTable& results,
                             const RunsLink& link) {
  std::string rows;
  for (const CrossRow& row : table.rows) {
    const std::string runs =
        link(table.method + ", " + table.descriptor.id + " in " + row.bin.label(), row.runs);
    std::string cells =
        "<th>" + html_escape(row.bin.label()) + runs_list(row, results, runs) + "</th>";
    for (std::size_t column = 0; column < scales.size(); ++column) {
      cells += cell_html(row.cells[column], scales[column], runs);
    }
    rows += "<tr>" + cells + "</tr>\n";
  }
  const std::string unit = table.descriptor.unit == "-" ? "" : " [" + table.descriptor.unit + "]";
  return "<div class=\"card\"><h4>" + heading + "</h4><table class=\"even\" style=\"min-width:" +
         std::to_string(9 + 8 * table.columns.size()) + "rem\">" +
         header_row({table.descriptor.name + unit}, table.columns) + "<tbody>" + rows +
         "</tbody></table>" + na_html(table) + "</div>\n";
}

std::vector<std::size_t> runs_of(const ResultTable& results, const std::string& method) {
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    if (results.runs[i].method == method) runs.push_back(i);
  }
  return runs;
}

}  // namespace

std::string html_summary_table(const SummaryTable& table, const ResultTable& results,
                               const RunsLink& link) {
  std::vector<ColumnScale> scales;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::vector<const Cell*> cells;
    for (const MethodSummary& method : table.methods) cells.push_back(&method.cells[column]);
    scales.push_back(make_scale(table.columns[column], cells));
  }
  const std::vector<std::string> methods = method_names(results);
  std::string rows;
  for (const MethodSummary& method : table.methods) {
    const std::size_t place = place_in(methods, method.method);
    const std::string runs = link("All runs of " + method.method, runs_of(results, method.method));
    std::string cells = "<th class=\"name\">" + method_swatch(place) + "<a href=\"" +
                        method_page_name(place) + "\">" + html_escape(method.method) +
                        "</a></th><td>" + std::to_string(method.n) + "</td>" +
                        outcome_cell(method, table.outcomes);
    for (std::size_t column = 0; column < scales.size(); ++column) {
      cells += cell_html(method.cells[column], scales[column], runs);
    }
    rows += "<tr>" + cells + "</tr>\n";
  }
  return "<div class=\"card\"><table>" + header_row({"Method", "Runs", "Outcomes"}, table.columns) +
         "<tbody>" + rows + "</tbody></table></div>\n";
}

std::string html_cross_tables(const std::vector<CrossTable>& tables, const ResultTable& results,
                              const std::vector<std::string>& methods, const RunsLink& link) {
  if (tables.empty()) return "";
  std::vector<ColumnScale> scales;
  for (std::size_t column = 0; column < tables.front().columns.size(); ++column) {
    std::vector<const Cell*> cells;
    for (const CrossTable& table : tables) {
      for (const CrossRow& row : table.rows) cells.push_back(&row.cells[column]);
    }
    scales.push_back(make_scale(tables.front().columns[column], cells));
  }
  std::string html;
  for (const CrossTable& table : tables) {
    const std::size_t place = place_in(methods, table.method);
    const std::string heading = method_swatch(place) + html_escape(table.method);
    html += cross_table_html(table, scales, heading, results, link);
  }
  return html;
}

}  // namespace slalom
