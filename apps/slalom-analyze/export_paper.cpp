// SPDX-License-Identifier: BSD-3-Clause
#include "export_paper.h"
#include "figure_file.h"

#include <slalom/analysis/data_table.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/report/figures.h>
#include <slalom/report/report.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace slalom {
namespace {

std::string value_of(const Manifest& manifest, const std::string& key) {
  const auto found = manifest.find(key);
  return found == manifest.end() ? "" : found->second;
}

/// A value of the .ini, for a sentence.
std::string rounded(const std::string& value) {
  double number = 0;
  return parse_number(value, number) ? fmt::format("{:.6g}", number) : latex_text(value);
}

std::string scan_text(int rays, double aperture_deg, double max_range) {
  return fmt::format("{} rays over {:.4g} degrees up to {:.6g}~m", rays, aperture_deg, max_range);
}

/// The lasers, and the scan that methods get.
std::string sensor_text(const SensorModel& sensor) {
  const std::string scan = scan_text(sensor.rays, sensor.aperture_deg, sensor.max_range);
  std::string text = "its laser has " + scan;
  if (!sensor.lasers.empty()) {
    std::vector<std::string> lasers;
    for (const LaserModel& laser : sensor.lasers)
      lasers.push_back(latex_text(laser.name) +
                       fmt::format(" at ({:.4g}, {:.4g})~m has ", laser.x, laser.y) +
                       scan_text(laser.rays, laser.aperture_deg, laser.max_range));
    text = "its laser " + join(lasers, ", ") + "; methods get " + scan;
  }
  return text + fmt::format(", with noise of {:.6g}~m", sensor.noise_sigma);
}

/// How the runs were made, of what the results contain.
std::string methods_paragraph(const ResultTable& results, double confidence) {
  const Manifest& manifest = results.manifest;
  const IniFile ini = IniFile::from_text(value_of(manifest, "campaign.effective"), "campaign");
  const auto key = [&](const std::string& section, const std::string& name) {
    return rounded(ini.get(section, name).value_or("?"));
  };
  std::string kinematics = ini.get("robot", "kinematics").value_or("");
  std::replace(kinematics.begin(), kinematics.end(), '_', ' ');
  const std::string footprint = ini.get("robot", "footprint").value_or("");
  const std::string shape = footprint.empty() ? "a disc of radius " + key("robot", "radius") + "~m"
                                              : "the polygon " + latex_text(footprint) + " (m)";
  const ReportOptions options = report_options(results);
  const SimulationOptions& simulation = options.simulation;
  const std::string limit = simulation.max_time
                                ? key("simulation", "max_time") + "~s"
                                : "the larger of 60~s and " + key("simulation", "time_factor") +
                                      " times the earliest possible arrival";
  std::vector<std::string> methods;
  for (const std::string& method : results.methods) methods.push_back(latex_text(method));
  std::string text = (methods.size() == 1 ? "The method " : "The methods ") + join(methods, ", ") +
                     " ran in " + count_text(results.scenario_hashes.size(), "scenario") + ", " +
                     count_text(results.size(), "run") + " in all, with Slalom " +
                     latex_text(value_of(manifest, "version.slalom")) + "~\\cite{slalom}.";
  if (!value_of(manifest, "campaign.effective").empty())
    text += " The robot (" + latex_text(kinematics) + ") is " + shape + " with at most " +
            key("robot", "max_v") + "~m/s and " + key("robot", "max_w") + "~rad/s; " +
            sensor_text(options.sensor) + ". Methods decide every " +
            key("simulation", "control_period") + "~s. A run succeeds within " +
            key("simulation", "goal_tolerance") + "~m of the goal; it ends by contact, after " +
            limit + ", or after " + fmt::format("{:.4g}", simulation.stuck_limit(options.robot)) +
            "~s without progress. The seed is " + latex_text(value_of(manifest, "seed")) + ".";
  return text + " Intervals are at " + format_number(100 * confidence) +
         "~\\%. The scenarios have the hash \\texttt{" +
         latex_text(value_of(manifest, "scenarios.hash")) + "}, the campaign \\texttt{" +
         latex_text(value_of(manifest, "campaign.identity")) + "}.\n";
}

/// The descriptor and its bins, which the tables of all methods have in common.
std::string bins_of(const CrossTable& table) {
  std::string text = table.descriptor.id;
  for (const CrossRow& row : table.rows) text += " " + row.bin.label();
  return text;
}

/// A name for a file and a label.
std::string file_name(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

}  // namespace

void write_paper(const ResultTable& results, const SummaryTable& summary,
                 const std::vector<CrossTable>& tables, const std::string& folder) {
  const std::string at = folder + "/";
  std::vector<std::string> parts = {"\\input{methods.tex}\n"};
  std::set<std::string> used, labels;
  const auto add_table = [&](const std::string& name, const std::string& text) {
    write_file_atomically(at + name + ".tex", number_labels(text, labels));
    parts.push_back("\\input{" + name + ".tex}\n");
  };
  const auto add_figure = [&](const std::string& name, const std::string& svg,
                              const std::string& caption) {
    write_figure(svg, at + name + ".pdf");
    add_table("figure_" + name,
              "\\begin{figure}\n\\centering\n\\includegraphics[width=\\linewidth]{" + name +
                  ".pdf}\n\\caption{" + caption + "}\n\\label{fig:" + name + "}\n\\end{figure}\n");
  };
  write_file_atomically(at + "methods.tex", methods_paragraph(results, summary.confidence));
  add_table("summary", render_latex(summary));
  add_figure("outcomes", outcome_figure(summary), "How the runs of each method end.");
  std::map<std::string, std::vector<CrossTable>> same_bins;
  for (const CrossTable& table : tables) same_bins[bins_of(table)].push_back(table);
  for (const CrossTable& table : tables) {
    add_table(unused_name(file_name(cross_data(table).name), used), render_latex(table));
    const std::vector<CrossTable> drawn = std::exchange(same_bins[bins_of(table)], {});
    if (drawn.empty()) continue;
    for (const Column& column : table.columns)
      add_figure(unused_name(file_name(column.info.id + "_by_" + table.descriptor.id), used),
                 bins_figure(drawn, column),
                 latex_text(column.info.name) + " over " + latex_text(table.descriptor.name) +
                     ", with the numbers of values n; hollow: of more than 10~\\% of the runs "
                     "there is none.");
  }
  write_file_atomically(
      at + "slalom.bib",
      "@misc{slalom,\n  author = {{The Slalom authors}},\n  title = {Slalom: automatic "
      "evaluation of obstacle avoidance methods for mobile robots},\n  note = {Version " +
          latex_text(value_of(results.manifest, "version.slalom")) + "}\n}\n");
  write_file_atomically(
      at + "paper.tex",
      "\\documentclass{article}\n\\usepackage{graphicx}\n\\IfFileExists{booktabs.sty}{\\usepackage"
      "{booktabs}}{\\let\\toprule\\hline\\let\\midrule\\hline\\let\\bottomrule\\hline}\n"
      "\\begin{document}\n" +
          join(parts, "\\clearpage\n") +
          "\\bibliographystyle{plain}\n\\bibliography{slalom}\n\\end{document}\n");
}

}  // namespace slalom
