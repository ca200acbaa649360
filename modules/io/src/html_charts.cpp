#include "html_charts.h"
#include "html_text.h"
#include "svg_chart.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/completion.h>
#include <slalom/analysis/descriptor_map.h>
#include <slalom/analysis/performance_profile.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr const char* kTime = "time_to_goal";
constexpr double kMostRatio = 16;  ///< profiles are drawn up to here

std::string color_of(const RunColumns& runs, const std::string& method) {
  return method_color(place_in(runs.methods, method));
}

std::string card(const std::string& heading, const std::string& content) {
  return html_element("div", "card", html_element("h4", "", heading) + content) + "\n";
}

/// `make`, or nothing where these results do not allow what it asks for.
template <typename Make>
std::string where_possible(Make make) {
  try {
    return make();
  } catch (const Error&) {
    return "";
  }
}

std::string profile_chart(const ChartContext& context, const Column& column) {
  const ProfileTable table = build_profiles(context.runs, column.info.id);
  std::vector<ChartLine> lines;
  for (const PerformanceProfile& profile : table.profiles) {
    ChartLine line{profile.method, color_of(context.runs, profile.method), {}};
    for (const ProfileStep& step : profile.steps)
      if (step.ratio <= kMostRatio) line.points.emplace_back(step.ratio, step.share);
    lines.push_back(std::move(line));
  }
  const ChartAxes axes{"ratio to the best method in the scenario", "share of scenarios", 1,
                       kMostRatio, true};
  return card("Performance profile of " + html_escape(column.info.id),
              step_chart(axes, lines) +
                  html_element("p", "support",
                               "Share of the " + std::to_string(table.scenarios) +
                                   " scenarios in which a method is within a ratio of the best "
                                   "one (Dolan and Moré 2002); the height at 1 is how often it is "
                                   "the best."));
}

std::string p_text(double p) {
  return p < 0.001 ? "p < 0.001" : "p = " + format_fixed(p, 3);
}

std::string rank_card(const ChartContext& context, const Column& column) {
  const MethodRanks ranks =
      build_method_ranks(context.runs, column.info.id, context.options.analysis);
  std::vector<std::string> colors;
  for (const std::string& method : ranks.methods) colors.push_back(color_of(context.runs, method));
  const std::string test =
      "Friedman test over " + count_text(ranks.test.scenarios, "scenario") + ": " +
      p_text(ranks.test.p) +
      "; bars join methods whose mean "
      "ranks do not differ by the critical difference (Nemenyi, level " +
      format_number(ranks.alpha) + ")." +
      (ranks.left_out > 0 ? " " + count_text(ranks.left_out, "scenario") +
                                " left out, in which not every method has a value."
                          : "");
  return card("Mean ranks in " + html_escape(column.info.id),
              rank_diagram(ranks, colors) + html_element("p", "support", html_escape(test)));
}

bool is_shown(const PairedComparison& comparison) {
  return comparison.verdict == Verdict::Better || comparison.verdict == Verdict::Worse ||
         comparison.verdict == Verdict::Different;
}

/// What was shown; the rest folded away below it.
std::string sentences(const std::vector<PairedComparison>& family, const std::string& method) {
  std::string shown, others;
  std::size_t not_shown = 0;
  for (const PairedComparison& comparison : family) {
    if (!method.empty() && comparison.a != method && comparison.b != method) continue;
    const bool is_difference = is_shown(comparison);
    not_shown += is_difference ? 0 : 1;
    (is_difference ? shown : others) +=
        html_element("p", is_difference ? "finding shown" : "finding soft",
                     html_escape(verdict_sentence(comparison)));
  }
  if (not_shown == 0) return shown;
  return shown + "<details><summary>" + count_text(not_shown, "comparison") +
         " without a difference shown</summary>" + others + "</details>";
}

std::string map_field(const MapField& field, const DescriptorMap& map, const RunsLink& link,
                      const std::string& title) {
  if (field.runs.empty()) return "<td class=\"cell na\">–</td>";
  const Cell& cell = field.cell;
  std::string style;
  if (map.column.rate && cell.estimate)
    style = " style=\"--g:" + format_fixed(*cell.estimate, 2) + "\"";
  const std::string estimate = cell.estimate ? estimate_text(cell, 2) : "–";
  return "<td class=\"cell\"" + style + "><a class=\"big\" href=\"" + link(title, field.runs) +
         "\">" + estimate + "</a>" + html_element("span", "interval", interval_text(cell, 2)) +
         html_element("span", "support", "n=" + std::to_string(cell.n)) + "</td>";
}

std::string map_card(const DescriptorMap& map, const ChartContext& context) {
  std::string header = "<th>" + html_escape(map.row_descriptor.id) + " \\ " +
                       html_escape(map.column_descriptor.id) + "</th>";
  for (const Bin& bin : map.columns) header += html_element("th", "", html_escape(bin.label()));
  std::string rows;
  for (std::size_t row = map.rows.size(); row-- > 0;) {  // as in a plot: upwards
    std::string cells = html_element("th", "", html_escape(map.rows[row].label()));
    for (std::size_t column = 0; column < map.columns.size(); ++column) {
      const std::string title = map.method + ", " + map.row_descriptor.id + " in " +
                                map.rows[row].label() + ", " + map.column_descriptor.id + " in " +
                                map.columns[column].label();
      cells += map_field(map.fields[row][column], map, context.link, title);
    }
    rows += html_element("tr", "", cells) + "\n";
  }
  const std::string left_out =
      map.left_out == 0
          ? ""
          : html_element("p", "support",
                         count_text(map.left_out, "run") + " outside all bins, or without a value");
  return card(method_swatch(place_in(context.runs.methods, map.method)) + html_escape(map.method) +
                  ": " + html_escape(map.column.info.id),
              "<table class=\"even\"><thead><tr>" + header + "</tr></thead><tbody>" + rows +
                  "</tbody></table>" + left_out);
}

/// The first two specifications of different descriptors.
std::vector<BinSpec> map_axes(const std::vector<BinSpec>& rows) {
  std::vector<BinSpec> axes;
  for (const BinSpec& spec : rows) {
    if (spec.kind == BinSpec::Kind::All) continue;
    if (axes.empty() || (axes.size() == 1 && axes[0].descriptor != spec.descriptor))
      axes.push_back(spec);
  }
  return axes;
}

std::string correlation_cell(const RankCorrelation& correlation) {
  if (!correlation.rho) return "<td class=\"na\">–</td>";
  std::string text = format_fixed(*correlation.rho, 2);
  if (correlation.interval)
    text += html_element("span", "interval",
                         "[" + format_fixed(correlation.interval->low, 2) + ", " +
                             format_fixed(correlation.interval->high, 2) + "]");
  return html_element("td", "", text);
}

}  // namespace

std::string completion_section(const ChartContext& context) {
  if (!find_metric(context.runs, kTime)) return "";
  std::vector<ChartLine> lines;
  double last = 0;
  for (const CompletionCurve& curve : build_completion(context.runs, kTime)) {
    ChartLine line{curve.method, color_of(context.runs, curve.method), {{0, 0}}};
    for (const CurvePoint& point : curve.incidence) {
      line.points.emplace_back(point.time, point.value);
      last = std::max(last, point.time);
    }
    lines.push_back(std::move(line));
  }
  if (last <= 0) return "";
  return "<h2 id=\"completion\">Completion</h2>\n" +
         card("Share of runs that had reached the goal by then",
              step_chart({"simulated time (s)", "share of runs", 0, last}, lines) +
                  html_element("p", "support",
                               "Aalen and Johansen's estimate: other ends compete with arriving, "
                               "so that each curve ends at the success rate."));
}

std::string ranking_section(const ChartContext& context) {
  if (context.runs.methods.size() < 2) return "";
  std::string html;
  for (const Column& column : directed_columns(context.runs, context.options)) {
    html += where_possible([&] { return rank_card(context, column); });
    if (!column.rate) html += where_possible([&] { return profile_chart(context, column); });
  }
  return html.empty() ? "" : "<h2 id=\"ranks\">Ranks and profiles</h2>\n" + html;
}

std::string comparison_section(const ChartContext& context) {
  const std::string text = sentences(context.contents.comparisons, "");
  if (text.empty()) return "";
  return "<h2 id=\"comparisons\">Method against method</h2>\n<p class=\"soft\">On the same "
         "scenarios; p values corrected for the number of comparisons (Holm).</p>\n" +
         html_element("div", "card", text) + "\n";
}

std::string map_section(const ChartContext& context, const std::string& method) {
  const std::vector<BinSpec> axes = map_axes(context.options.rows);
  if (axes.size() < 2 || context.options.columns.empty()) return "";
  std::string html;
  for (const std::string& name : context.runs.methods) {
    if (!method.empty() && name != method) continue;
    html += where_possible([&] {
      return map_card(
          build_descriptor_map(context.runs, name, axes[0], axes[1],
                               context.options.columns.front(), context.options.analysis),
          context);
    });
  }
  return html.empty() ? "" : "<h2 id=\"maps\">Maps</h2>\n" + html;
}

std::string validity_table(const ChartContext& context, const std::string& method) {
  if (!context.contents.validity) return "";
  const ValidityTable& table = *context.contents.validity;
  std::vector<std::string> metrics;
  for (const Column& column : directed_columns(context.runs, context.options))
    metrics.push_back(column.info.id);
  std::string header = "<th>Descriptor</th>", rows;
  for (const std::string& metric : metrics) header += html_element("th", "", html_escape(metric));
  for (const std::string& descriptor : table.descriptors) {
    std::string cells = html_element("th", "", html_escape(descriptor));
    for (const std::string& metric : metrics) {
      for (const DescriptorValidity& entry : table.validity) {
        if (entry.method == method && entry.descriptor == descriptor && entry.metric == metric)
          cells += correlation_cell(entry.correlation);
      }
    }
    rows += html_element("tr", "", cells) + "\n";
  }
  return "<h2>What makes it hard</h2>\n<p class=\"soft\">Spearman's rank correlation of each "
         "descriptor of the scenarios with how the method did, with intervals.</p>\n"
         "<div class=\"card\"><table><thead><tr>" +
         header + "</tr></thead><tbody>" + rows + "</tbody></table></div>\n";
}

std::string comparisons_of(const ChartContext& context, const std::string& method) {
  const std::string text = sentences(context.contents.comparisons, method);
  if (text.empty()) return "";
  return "<h2>Against the others</h2>\n" + html_element("div", "card", text) + "\n";
}

}  // namespace slalom
