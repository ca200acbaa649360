#include "html_method_page.h"
#include "html_text.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

std::string summary_of(const ChartContext& context, const std::string& method) {
  SummaryTable summary = context.contents.summary;
  std::vector<MethodSummary> only;
  for (MethodSummary& entry : summary.methods) {
    if (entry.method == method) only.push_back(std::move(entry));
  }
  summary.methods = std::move(only);
  return html_summary_table(summary, context.table, context.link);
}

std::string endings_of(const ChartContext& context, const std::string& method) {
  std::string rows;
  for (const OutcomeGroup& group : context.contents.endings.groups) {
    if (group.method != method) continue;
    for (const OutcomeShare& share : group.outcomes) {
      if (share.runs.empty()) continue;
      const std::string link = context.link(method + ": " + share.outcome, share.runs);
      const std::string interval = share.interval
                                       ? " [" + format_fixed(share.interval->low, 2) + ", " +
                                             format_fixed(share.interval->high, 2) + "]"
                                       : "";
      rows += "<tr><th>" + outcome_chip(share.outcome) + "</th><td>" +
              format_fixed(share.share, 2) + interval + "</td><td><a href=\"" + link + "\">" +
              count_text(share.runs.size(), "run") + "</a></td></tr>\n";
    }
  }
  return "<h2>How its runs ended</h2>\n<div class=\"card\"><table><tbody>" + rows +
         "</tbody></table></div>\n";
}

std::string tables_of(const ChartContext& context, const std::string& method) {
  std::string html = "<h2>Where</h2>\n";
  for (const std::vector<CrossTable>& group : context.contents.tables) {
    for (const CrossTable& table : group) {
      if (table.method == method)
        html += html_cross_tables({table}, context.table, context.runs.methods, context.link);
    }
  }
  return html;
}

}  // namespace

std::string method_page_name(std::size_t place) {
  return "method-" + std::to_string(place + 1) + ".html";
}

std::string method_page(const ChartContext& context, const std::string& method,
                        const std::string& campaign) {
  return html_page(campaign + ": " + method,
                   "<header><h1>" + html_escape(method) +
                       "</h1><p><a href=\"index.html\">Report of " + html_escape(campaign) +
                       "</a></p></header>\n<main>\n" + summary_of(context, method) +
                       endings_of(context, method) + comparisons_of(context, method) +
                       tables_of(context, method) + map_section(context, method) +
                       validity_table(context, method) + "</main>\n");
}

}  // namespace slalom
