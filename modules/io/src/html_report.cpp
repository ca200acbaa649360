#include "html_charts.h"
#include "html_gallery.h"
#include "html_method_page.h"
#include "html_tables.h"
#include "html_text.h"
#include "run_pages.h"

#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/findings.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/html_report.h>

#include <filesystem>
#include <system_error>

namespace slalom {
namespace {

/// What every section of a report is made from.
struct ReportContext {
  const ResultTable& table;
  const ReportOptions& options;
  const RunColumns& runs;  ///< the same as `table`
  const ReportContents& contents;
  std::vector<std::string> methods;
  std::vector<Column> columns;
  Gallery gallery;
  std::vector<RunGroup>& groups;  ///< grows with each table's cells

  ChartContext charts() const { return {runs, table, options, contents, link()}; }

  RunsLink link() const {
    return [this](const std::string& title, const std::vector<std::size_t>& runs) {
      groups.push_back({title, runs});
      return "runs.html#cell-" + std::to_string(groups.size() - 1);
    };
  }
};

std::string manifest_entry(const Manifest& manifest, const std::string& key) {
  const auto found = manifest.find(key);
  return found == manifest.end() ? "" : found->second;
}

std::string campaign_name(const Manifest& manifest) {
  const std::string name = manifest_entry(manifest, "campaign");
  return name.empty() ? "campaign" : name;
}

std::string fact(const std::string& figure, const std::string& what) {
  return "<div><b>" + html_escape(figure) + "</b><span>" + html_escape(what) + "</span></div>";
}

std::string overview(const ReportContext& context) {
  const ResultTable& table = context.table;
  std::size_t successes = 0;
  for (const RunRecord& run : table.runs) successes += run.outcome == "success" ? 1 : 0;
  const std::string version = manifest_entry(table.manifest, "version.slalom");
  return "<header><h1>" + html_escape(campaign_name(table.manifest)) +
         "</h1><p class=\"soft\">Evaluation of obstacle avoidance methods</p>"
         "<div class=\"facts\">" +
         fact(std::to_string(context.methods.size()), "methods") +
         fact(std::to_string(table.scenarios.size()), "scenarios") +
         fact(std::to_string(table.runs.size()), "runs") +
         fact(std::to_string(successes), "runs reached the goal") +
         (version.empty() ? "" : fact(version, "Slalom version")) + "</div></header>\n";
}

/// Links to the sections that this report has.
std::string navigation(const std::string& sections) {
  const std::string start = "<h2 id=\"";
  std::string links;
  for (auto at = sections.find(start); at != std::string::npos; at = sections.find(start, at + 1)) {
    const auto id = at + start.size(), quote = sections.find('"', id);
    const auto end = sections.find("</h2>", id);
    links += "<a href=\"#" + sections.substr(id, quote - id) + "\">" +
             sections.substr(quote + 2, end - quote - 2) + "</a>";
  }
  return "<nav><div>" + links + "<a href=\"runs.html\">All runs</a></div></nav>\n";
}

std::string how_to_read(const ReportContext& context) {
  const std::string percent = format_number(context.options.analysis.confidence * 100);
  return "<p class=\"soft\">Each cell: the mean (for success the share of runs) with its " +
         percent +
         " % interval, drawn below on the column's scale; then the standard deviation and the "
         "number "
         "of runs. NA counts runs without a value, which enter no mean. ↑ more is better, ↓ less "
         "is "
         "better; a stronger shade is better within its column; cells with fewer than 5 values are "
         "not "
         "shaded.</p>\n";
}

std::string summary_section(const ReportContext& context) {
  return "<h2 id=\"summary\">Summary</h2>\n" +
         html_summary_table(context.contents.summary, context.table, context.link()) +
         how_to_read(context);
}

std::string findings_of(const CrossTable& table) {
  std::string html;
  for (const Finding& finding : condensed_findings(table)) {
    const bool shown = finding.verdict == Finding::Verdict::Difference;
    html += html_element("p", shown ? "finding shown" : "finding soft", html_escape(finding.text));
  }
  return html + "\n";
}

std::string findings_section(const ReportContext& context) {
  std::string html;
  for (const auto& group : context.contents.tables) {
    std::string sentences;
    for (const CrossTable& table : group) sentences += findings_of(table);
    if (group.empty() || group.front().rows.size() < 2) continue;
    html += html_element("h3", "", "By " + html_escape(group.front().descriptor.name)) +
            html_element("div", "card", sentences);
  }
  if (html.empty()) html = "<p>There are no bins to compare.</p>";
  return "<h2 id=\"findings\">Findings</h2>\n<p class=\"soft\">The lowest and the highest bin with "
         "10 values or more are "
         "compared; they are called different only where their intervals do not overlap. That they "
         "overlap is no proof that there is no difference.</p>\n" +
         html;
}

std::string tables_section(const ReportContext& context) {
  std::string html = "<h2 id=\"tables\">Cross tables</h2>\n";
  for (const auto& group : context.contents.tables) {
    if (group.empty()) continue;
    const QuantityInfo& descriptor = group.front().descriptor;
    html += "<h3>By " + html_escape(descriptor.name) + " <code>" + html_escape(descriptor.id) +
            "</code></h3>\n" +
            html_cross_tables(group, context.table, context.methods, context.link());
  }
  return html;
}

std::string scenarios_section(const ReportContext& context) {
  std::string html =
      "<h2 id=\"scenarios\">Scenarios</h2>\n" + gallery_legend(context.methods) + "\n";
  const auto& pages = context.gallery.pages;
  if (pages.size() == 1) return html + html_element("div", "gallery", pages.front().html) + "\n";
  html += "<ul class=\"plain\">";
  for (std::size_t i = 0; i < pages.size(); ++i) {
    html += "<li><a href=\"" + pages[i].name + "\">Scenarios, page " + std::to_string(i + 1) +
            " of " + std::to_string(pages.size()) + "</a></li>\n";
  }
  return html + "</ul>\n";
}

std::string repeat_section(const Manifest& manifest) {
  std::string rows, texts;
  for (const auto& [key, text] : manifest) {
    if (text.find('\n') == std::string::npos) {
      rows += "<tr><th>" + html_escape(key) + "</th><td><code>" + html_escape(text) +
              "</code></td></tr>\n";
    } else {
      texts += "<details open><summary>" + html_escape(key) + "</summary><pre>" +
               html_escape(text) + "</pre></details>\n";
    }
  }
  return "<h2 id=\"repeat\">How to repeat it</h2>\n<p>Save <code>campaign.ini</code> below and run "
         "<code>slalom-evaluate campaign.ini -o out</code>, or <code>slalom-simulate run -c "
         "campaign.ini</code> over the scenario list it was made with, using the versions listed: "
         "everything but wall-clock figures comes out the same.</p>\n"
         "<div class=\"card\"><table><tbody>" +
         rows + "</tbody></table>" + texts + "</div>\n";
}

std::string footer() {
  return "<footer>Written by Slalom " + html_escape(version()) + "</footer>\n";
}

/// Comparisons and charts, each where the results allow it.
std::string charts(const ReportContext& context) {
  const ChartContext chart = context.charts();
  return comparison_section(chart) + completion_section(chart) + ranking_section(chart) +
         map_section(chart);
}

std::string index_page(const ReportContext& context) {
  const std::string sections = summary_section(context) + findings_section(context) +
                               tables_section(context) + charts(context) +
                               scenarios_section(context) + repeat_section(context.table.manifest);
  return html_page(
      campaign_name(context.table.manifest) + " - Slalom report",
      overview(context) + navigation(sections) + "<main>\n" + sections + "</main>\n" + footer());
}

std::string scenario_page(const ReportContext& context, const Gallery::Page& page) {
  const std::string name = campaign_name(context.table.manifest);
  return html_page(name + " - scenarios",
                   "<header><h1>" + html_escape(name) +
                       ": scenarios</h1><p><a href=\"index.html\">Back to the report</a></p>"
                       "</header>\n<main>\n" +
                       gallery_legend(context.methods) + html_element("div", "gallery", page.html) +
                       "</main>\n" + footer());
}

void make_directory(const std::string& directory) {
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem || !std::filesystem::is_directory(directory, problem)) {
    throw job_error(directory, "cannot be made: " + problem.message(), "a folder to write to");
  }
}

void write_method_pages(const ReportContext& context, const std::filesystem::path& folder) {
  for (std::size_t place = 0; place < context.methods.size(); ++place) {
    write_file_atomically((folder / method_page_name(place)).string(),
                          method_page(context.charts(), context.methods[place],
                                      campaign_name(context.table.manifest)));
  }
}

/// The campaign as the manifest has it; an empty one where that cannot be read.
IniFile campaign_ini(const Manifest& manifest) {
  try {
    return IniFile::from_text(manifest_entry(manifest, "campaign.ini"), "campaign.ini");
  } catch (const Error&) {
    return IniFile::from_text("");
  }
}

/// By density where it is known of any scenario.
std::vector<BinSpec> default_rows(const ResultTable& table) {
  for (const auto& [hash, scenario] : table.scenarios) {
    if (scenario.descriptors.count("density") > 0) return {parse_bin_spec("density:q4")};
  }
  return {BinSpec{}};
}

/// The paper's three metrics, as far as the results have them.
std::vector<std::string> default_columns(const ResultTable& table) {
  std::vector<std::string> columns = {"success"};
  for (const std::string& id : metric_ids(table)) {
    if (id == "optimality" || id == "safety") columns.push_back(id);
  }
  return columns;
}

}  // namespace

ReportOptions report_options(const ResultTable& table) {
  const IniFile ini = campaign_ini(table.manifest);
  ReportOptions options;
  const auto section = read_options<AnalysisSection>(ini, "analysis");
  options.rows = section.rows.empty() ? default_rows(table) : parse_bin_specs(section.rows);
  options.columns = section.columns.empty() ? default_columns(table) : split(section.columns, ',');
  options.analysis.confidence = section.confidence;
  options.robot = read_robot_model(ini);
  options.sensor = read_options<SensorModel>(ini, "sensor");
  parse_number(ini.get("simulation", "resolution").value_or(""), options.resolution);
  return options;
}

void write_html_report(const ResultFile& file, const ReportOptions& options,
                       const std::string& directory) {
  const ResultTable table = file.read_table();
  const std::vector<Column> columns = resolve_columns(table, options.columns);
  const RunColumns runs = to_columns(table);
  const ReportContents contents = make_report_contents(runs, options);
  std::vector<RunGroup> groups;
  const ReportContext context{table,
                              options,
                              runs,
                              contents,
                              method_names(table),
                              columns,
                              make_gallery(file, table, columns, options.robot.radius),
                              groups};
  const std::string index = index_page(context);
  make_directory(directory);
  write_method_pages(context, directory);
  write_run_pages({file, table, columns, groups, context.gallery.links, options.robot,
                   options.sensor, options.resolution},
                  directory);
  const std::filesystem::path folder(directory);
  for (const Gallery::Page& page : context.gallery.pages) {
    if (page.name.empty()) continue;
    write_file_atomically((folder / page.name).string(), scenario_page(context, page));
  }
  write_file_atomically((folder / "index.html").string(), index);
}

}  // namespace slalom
