// SPDX-License-Identifier: BSD-3-Clause
#include "import_table.h"
#include "key_options.h"
#include "warnings.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/read_results.h>
#include <slalom/tables/analysis_input.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace slalom {
namespace {

struct ImportArguments {
  std::vector<std::string> tables;
  CsvColumnOptions columns;
  std::string output;
  bool quiet = false;
};

ResultTable read_tables(const ImportArguments& arguments) {
  for (const std::string& path : arguments.tables)
    if (is_result_input(path))
      throw usage_error(path, "contains results already", "a table of another program");
  return arguments.tables.size() == 1
             ? read_analysis_input(arguments.tables[0], std::nullopt, true, arguments.columns)
             : read_analysis_tables(arguments.tables, arguments.columns);
}

void import_tables(const ImportArguments& arguments) {
  if (!ends_with(arguments.output, ".results"))
    throw usage_error("--output", "'" + arguments.output + "' is not the name of a result file",
                      "FILE.results");
  const ResultTable table = read_tables(arguments);
  write_imported(table, arguments.output);
  if (arguments.quiet) return;
  warn_of_missing(table.source, table);
  std::cerr << arguments.output << ": " << count_text(table.size(), "run") << " of "
            << count_text(table.methods.size(), "method") << " in "
            << count_text(table.scenario_hashes.size(), "scenario") << ", "
            << count_text(table.metrics.size(), "column") << " of numbers\n";
}

}  // namespace

void define_import(CLI::App& app) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* verb = app.add_subcommand(
      "import", "Make a result file of tables of other programs, for all other verbs");
  verb->add_option("tables", arguments->tables,
                   "Tables, one for each method or one of all: CSV, a workbook (.xlsx), JSON (an "
                   "array of rows or arrays by column), a benchmark of OMPL (.db) or Bench-MR")
      ->required();
  add_key_options(*verb, arguments->columns, true);
  verb->add_option("-o,--output", arguments->output, "Result file to write (.results)")->required();
  verb->add_flag("--quiet", arguments->quiet, "No messages");
  verb->callback([arguments] { import_tables(*arguments); });
}

}  // namespace slalom
