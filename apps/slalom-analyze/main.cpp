#include "export.h"
#include "interpret.h"
#include "metrics.h"
#include "show.h"

#include <slalom/app/program.h>
#include <slalom/core/text.h>
#include <slalom/io/html_report.h>
#include <slalom/io/rawlog_place.h>
#include <slalom/io/result_file.h>

#include <filesystem>
#include <iostream>
#include <string>

namespace slalom {
namespace {

/// What all verbs take from the command line.
struct Arguments {
  std::string results;  ///< the file
  std::string rows, columns, output, run;
  double confidence = 0;  ///< 0: as the campaign says
  bool json = false, quiet = false;
};

CLI::App* add_verb(CLI::App& app, const std::string& name, const std::string& help,
                   Arguments& arguments) {
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  return verb;
}

void add_table_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option(
      "--rows", arguments.rows,
      "Bins of a scenario descriptor: all, ID:EDGE,EDGE,..., ID:COUNT (equal width) "
      "or ID:qCOUNT (as many scenarios each); several separated by ';' (default: as the "
      "campaign's [analysis] says)");
  verb.add_option("--columns", arguments.columns,
                  "Metric ids, comma separated (default: as the campaign's [analysis] says)");
  verb.add_option("--confidence", arguments.confidence, "Of intervals, e.g. 0.95")
      ->check(CLI::Range(0.5, 0.9999));
}

/// The campaign's own wishes, then those of the command line.
ReportOptions effective_options(const ResultTable& table, const Arguments& arguments) {
  ReportOptions options = report_options(table);
  if (!arguments.rows.empty()) options.rows = parse_bin_specs(arguments.rows);
  if (!arguments.columns.empty()) options.columns = split(arguments.columns, ',');
  if (arguments.confidence > 0) options.analysis.confidence = arguments.confidence;
  return options;
}

void print_or_write(const std::string& text, const std::string& output) {
  if (output.empty() || output == "-") {
    std::cout << text;
  } else {
    write_file_atomically(output, text);
  }
}

void report_verb(const Arguments& arguments) {
  const ResultFile file = ResultFile::open(arguments.results);
  write_html_report(file, effective_options(file.read_table(), arguments), arguments.output);
  if (arguments.quiet) return;
  const std::filesystem::path index = std::filesystem::path(arguments.output) / "index.html";
  std::cerr << "report: " << index.string() << "\n";
}

void show_verb(const Arguments& arguments) {
  const ResultTable table = ResultFile::open(arguments.results).read_table();
  const RunRecord& run = find_run(table, arguments.run);
  if (arguments.json) {
    std::cout << dump_line(table, run) << "\n";
    return;
  }
  std::cout << run_text(table, run);
  const std::string rawlog =
      rawlog_path(arguments.results, run.scenario_hash, run.method, run.repetition);
  if (std::filesystem::exists(rawlog))
    std::cout << "rawlog, see slalom-replay\n  " << rawlog << "\n";
}

void dump_verb(const Arguments& arguments) {
  const ResultTable table = ResultFile::open(arguments.results).read_table();
  std::string text;
  for (const RunRecord& run : table.runs) text += dump_line(table, run) + "\n";
  print_or_write(text, arguments.output);
}

void define_report(CLI::App& app, Arguments& arguments) {
  CLI::App* verb =
      add_verb(app, "report", "Write an HTML report that opens without a network", arguments);
  add_table_options(*verb, arguments);
  verb->add_option("-o,--output", arguments.output, "Folder to write to")->required();
  verb->add_flag("--quiet", arguments.quiet, "Do not say where the report is");
  verb->callback([&arguments] { report_verb(arguments); });
}

void define_show(CLI::App& app, Arguments& arguments) {
  CLI::App* verb = add_verb(app, "show", "Print everything known of one run", arguments);
  verb->add_option("--run", arguments.run, "The run: HASH8/METHOD/REPETITION")->required();
  verb->add_flag("--json", arguments.json, "As the line that dump prints");
  verb->callback([&arguments] { show_verb(arguments); });
}

void define_dump(CLI::App& app, Arguments& arguments) {
  CLI::App* verb =
      add_verb(app, "dump", "Print every deterministic value, one run a line of JSON", arguments);
  verb->add_option("-o,--output", arguments.output, "File to write instead of standard output");
  verb->callback([&arguments] { dump_verb(arguments); });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  using namespace slalom;
  Arguments arguments;
  return run_program("slalom-analyze",
                     "Tables and reports from result files, and metrics of any robot's logs", argc,
                     argv, [&arguments](CLI::App& app) {
                       define_interpreters(app);
                       define_report(app, arguments);
                       define_show(app, arguments);
                       define_dump(app, arguments);
                       define_export(app);
                       define_metrics(app);
                     });
}
