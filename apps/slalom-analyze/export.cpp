// SPDX-License-Identifier: BSD-3-Clause
#include "export.h"
#include "export_paper.h"
#include "warnings.h"

#include <slalom/analysis/data_table.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/app/output_folder.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/planner_arena/benchmark_database.h>
#include <slalom/report/report.h>
#include <slalom/results/privileged.h>
#include <slalom/spreadsheet/workbook.h>

#include <filesystem>
#include <iostream>
#include <set>

namespace slalom {
namespace {

struct ExportArguments {
  std::string results, format, output;
  bool quiet = false;
};

/// The results and the tables configured in the campaign's [analysis].
struct ExportData {
  ResultTable results;
  SummaryTable summary;
  std::vector<CrossTable> cross_tables;

  /// All data as plain tables, each with a name of its own, which refer to this object.
  std::vector<DataTable> tables() const {
    std::vector<DataTable> all = {summary_data(summary)};
    std::set<std::string> used;
    for (const CrossTable& table : cross_tables) {
      all.push_back(cross_data(table));
      all.back().name = unused_name(all.back().name, used);
    }
    all.insert(all.begin(),
               {runs_table(results), scenarios_table(results), timings_table(results)});
    all.push_back(manifest_table(results));
    return all;
  }
};

/// Whether the output is one file by its name, with the table of runs.
bool is_one_file(const std::string& output, const char* ending) {
  return ends_with(output, ending) && !std::filesystem::is_directory(output);
}

/// Writes one file per table into a folder.
void write_tables(const ExportData& data, const std::string& folder, const char* ending,
                  std::string (*render)(const DataTable&)) {
  if (is_one_file(folder, ending))
    return write_file_atomically(folder, render(runs_table(data.results)));
  make_output_folder(folder);
  for (const DataTable& table : data.tables()) {
    if (table.name.find('/') != std::string::npos)
      throw file_error(data.results.source, "contains the name '" + table.name + "'",
                       "names without '/'");
    const auto path = std::filesystem::path(folder) / (table.name + ending);
    write_file_atomically(path.string(), render(table));
  }
}

void write_csv(const ExportData& data, const std::string& output) {
  write_tables(data, output, ".csv", render_csv);
}

void write_json(const ExportData& data, const std::string& output) {
  write_tables(data, output, ".json", render_json);
}

void write_xlsx(const ExportData& data, const std::string& output) {
  write_workbook(data.tables(), output);
}

void write_latex(const ExportData& data, const std::string& output) {
  std::vector<std::string> tables = {render_latex(data.summary)};
  for (const CrossTable& table : data.cross_tables) tables.push_back(render_latex(table));
  write_file_atomically(output, latex_document(tables));
}

void write_plannerarena(const ExportData& data, const std::string& output) {
  write_benchmark_database(data.results, output);
}

void write_paper(const ExportData& data, const std::string& output) {
  make_output_folder(output);
  write_paper(data.results, data.summary, data.cross_tables, output);
}

struct Format {
  const char* name;
  const char* extension;  ///< of the file
  bool may_be_folder;     ///< without the extension
  void (*write)(const ExportData& data, const std::string& output);
};

/// All formats; add new ones here.
constexpr Format kFormats[] = {
    {"csv", ".csv", true, write_csv},       {"json", ".json", true, write_json},
    {"xlsx", ".xlsx", false, write_xlsx},   {"latex", ".tex", false, write_latex},
    {"paper", ".paper", true, write_paper}, {"plannerarena", ".db", false, write_plannerarena},
};

/// The given format, or that of the output's extension.
const Format& format_of(const ExportArguments& arguments) {
  for (const Format& format : kFormats) {
    if (arguments.format == format.name) return format;
    if (arguments.format.empty() && ends_with(arguments.output, format.extension)) return format;
  }
  throw usage_error(
      "-o " + arguments.output, "its name does not tell the format",
      "a file .csv, .json, .xlsx, .tex or .db, or --format, as csv or json for a folder");
}

void run(const ExportArguments& arguments) {
  const Format& format = format_of(arguments);
  ExportData data;
  data.results = read_detailed_results(arguments.results);
  warn_of_missing(arguments.results, data.results);
  const ReportOptions options = report_options(data.results);
  const std::vector<std::string> names = data.results.methods;
  mark_privileged(data.results);
  data.summary = build_summary(data.results, options.columns, options.analysis);
  data.cross_tables =
      build_cross_tables(data.results, options.rows, options.columns, options.analysis);
  data.results.methods = names;  // those of the tables of runs, which are the data
  format.write(data, arguments.output);
  const bool is_folder = format.may_be_folder && !is_one_file(arguments.output, format.extension);
  if (!arguments.quiet)
    std::cerr << arguments.output << (is_folder ? ": folder written\n" : ": written\n");
}

}  // namespace

void define_export(CLI::App& app) {
  static ExportArguments arguments;
  CLI::App* verb = app.add_subcommand("export", "Export results for other programs");
  verb->add_option("results", arguments.results,
                   "A result file (.results), or a folder with the shards of a campaign")
      ->required();
  std::vector<std::string> names;
  for (const Format& format : kFormats) names.emplace_back(format.name);
  verb->add_option(
          "--format", arguments.format,
          "csv or json (a folder with a file per table; the runs if the output is a .csv or "
          ".json), xlsx, latex, paper (a folder with tables, figures and the text about how the "
          "runs were made), or plannerarena (a database for OMPL's Planner Arena); "
          "default: by the output's name, .csv, .json, .xlsx, .tex or .db")
      ->check(CLI::IsMember(names));
  verb->add_option("-o,--output", arguments.output, "File or folder to write")->required();
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
