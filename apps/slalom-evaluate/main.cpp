#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_text.h>
#include <slalom/app/campaign_arguments.h>
#include <slalom/app/campaign_program.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/app/sequential_campaign.h>
#include <slalom/core/error.h>
#include <slalom/io/html_report.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>

#include <iostream>

namespace slalom {
namespace {

struct Arguments {
  CampaignArguments campaign;
  SequentialArguments sequential;
  std::string output;
};

void keep_scenarios(const std::vector<Scenario>& scenarios, const IniFile& ini,
                    const std::string& path) {
  ScenarioList list = ScenarioList::create(path);
  list.add_all(scenarios);
  list.set_note("campaign.ini", ini.canonical_text());
}

/// Tables on standard output and as files, the report as a folder.
void present(const Arguments& arguments, const std::string& results_path, bool with_report) {
  const ResultFile file = ResultFile::open(results_path);
  const ResultTable table = file.read_table();
  const ReportOptions options = report_options(table);
  const std::string text =
      render_tables_text(table, options.rows, options.columns, options.analysis.confidence);
  write_file_atomically(arguments.output + "/tables.txt", text);
  write_file_atomically(
      arguments.output + "/tables.csv",
      render_csv(build_cross_tables(table, options.rows, options.columns, options.analysis)));
  std::cout << text;
  if (!with_report) return;
  const std::string report = arguments.output + "/report";
  write_html_report(file, options, report);
  std::cout << "\nReport: " << report << "/index.html\n";
}

/// All scenarios, or as many as it takes.
CampaignReport run(const Arguments& arguments, const IniFile& ini, std::vector<Scenario> scenarios,
                   const std::string& results) {
  if (arguments.sequential.until.empty())
    return run_campaign_program(ini, arguments.campaign, std::move(scenarios), results);
  const SequentialReport report =
      run_until(ini, arguments.campaign, arguments.sequential, std::move(scenarios), results);
  write_file_atomically(arguments.output + "/until.txt", report.text);
  std::cout << report.text << "\n";
  return report.campaign;
}

void evaluate(const Arguments& arguments) {
  const IniFile ini = load_campaign_ini(arguments.campaign);
  make_output_folder(arguments.output);
  const std::string results = arguments.output + "/runs.results";
  std::vector<Scenario> scenarios = campaign_scenarios(ini, arguments.campaign);
  keep_scenarios(scenarios, ini, arguments.output + "/campaign.scenarios");
  const CampaignReport report = run(arguments, ini, std::move(scenarios), results);
  if (!report.complete) throw Interrupted("the runs so far are kept in " + results);
  present(arguments, results, read_options<AnalysisSection>(ini, "analysis").report);
  if (!report.problem.empty()) throw job_error(results, report.problem);
}

void define(CLI::App& app) {
  static Arguments arguments;
  app.add_option("config", arguments.campaign.config, "The campaign's .ini")->required();
  app.add_option("-o,--output", arguments.output,
                 "Folder for campaign.scenarios, runs.results, tables and report/")
      ->required();
  add_campaign_options(app, arguments.campaign);
  CLI::Option* until = app.add_option("--until", arguments.sequential.until,
                                      "Add runs only where a result is not precise enough: "
                                      "\"interval(success) < 0.1 in density:10\"");
  app.add_option("--max-runs", arguments.sequential.max_runs,
                 "With --until: no further batch after that many runs")
      ->needs(until);
  app.add_flag_callback(
      "--options",
      [] {
        std::cout << campaign_options_help();
        throw CLI::Success();
      },
      "List every section and key of a campaign .ini and exit");
  app.callback([] { evaluate(arguments); });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-evaluate",
                             "Runs a whole campaign: scenarios, runs, tables, report.", argc, argv,
                             slalom::define);
}
