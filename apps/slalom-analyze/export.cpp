#include "export.h"

#include <slalom/analysis/data_table.h>
#include <slalom/analysis/table_latex.h>
#include <slalom/core/error.h>
#include <slalom/io/html_report.h>
#include <slalom/io/result_file.h>
#include <slalom/planner_arena/benchmark_database.h>
#include <slalom/spreadsheet/workbook.h>

#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

struct ExportArguments {
  std::string results, format, output;
  bool quiet = false;
};

/// The results and the tables that the campaign's [analysis] asks for.
struct Exported {
  ResultTable results;
  SummaryTable summary;
  std::vector<CrossTable> crossed;

  /// All as plain tables; `this` must outlive them.
  std::vector<DataTable> tables() const {
    std::vector<DataTable> all = {runs_table(results), scenarios_table(results),
                                  timings_table(results), summary_data(summary)};
    for (const CrossTable& table : crossed) all.push_back(cross_data(table));
    all.push_back(manifest_table(results));
    return all;
  }
};

/// One file per table in a folder.
void write_folder(const Exported& exported, const std::string& folder, const char* ending,
                  std::string (*render)(const DataTable&)) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw job_error(folder, "cannot be made: " + error.message(), "a folder");
  for (const DataTable& table : exported.tables()) {
    const auto path = std::filesystem::path(folder) / (table.name + ending);
    write_file_atomically(path.string(), render(table));
  }
}

void write_csv(const Exported& exported, const std::string& output) {
  write_folder(exported, output, ".csv", render_csv);
}

void write_json(const Exported& exported, const std::string& output) {
  write_folder(exported, output, ".json", render_json);
}

void write_xlsx(const Exported& exported, const std::string& output) {
  write_workbook(exported.tables(), output);
}

void write_latex(const Exported& exported, const std::string& output) {
  std::vector<std::string> tables = {render_latex(exported.summary)};
  for (const CrossTable& table : exported.crossed) tables.push_back(render_latex(table));
  write_file_atomically(output, latex_document(tables));
}

void write_plannerarena(const Exported& exported, const std::string& output) {
  write_benchmark_database(exported.results, output);
}

struct Format {
  const char* name;
  void (*write)(const Exported& exported, const std::string& output);
};

/// All formats: the one list to add a line to.
constexpr Format kFormats[] = {
    {"csv", write_csv},
    {"json", write_json},
    {"xlsx", write_xlsx},
    {"latex", write_latex},
    {"plannerarena", write_plannerarena},
};

void run(const ExportArguments& arguments) {
  Exported exported;
  exported.results = ResultFile::open(arguments.results).read_table();
  const ReportOptions options = report_options(exported.results);
  exported.summary = build_summary(exported.results, options.columns, options.analysis);
  exported.crossed =
      build_cross_tables(exported.results, options.rows, options.columns, options.analysis);
  for (const Format& format : kFormats) {
    if (arguments.format == format.name) format.write(exported, arguments.output);
  }
  if (!arguments.quiet) std::cerr << arguments.output << ": written\n";
}

}  // namespace

void define_export(CLI::App& app) {
  static ExportArguments arguments;
  CLI::App* verb = app.add_subcommand("export", "Write results for other programs");
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  std::vector<std::string> names;
  for (const Format& format : kFormats) names.emplace_back(format.name);
  verb->add_option("--format", arguments.format,
                   "csv or json (a folder with a file per table), xlsx, latex, or plannerarena (a "
                   "database for OMPL's Planner Arena)")
      ->required()
      ->check(CLI::IsMember(names));
  verb->add_option("-o,--output", arguments.output, "File or folder to write")->required();
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
