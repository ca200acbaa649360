// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/analysis_request.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/interpreter.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace slalom {

/// Command-line arguments of an analysis.
struct InterpretArguments {
  AnalysisRequest request;
  std::vector<std::string> files;
  std::string scenarios;   ///< list with the indexes of the rows
  std::string csv_file;    ///< of --csv
  CsvColumnOptions table;  ///< of CSV files
  std::string output;
  bool csv = false, json = false, latex = false, html = false, markdown = false;
  bool methods_as_columns = false;
  int jobs = 1;  ///< threads that read shards
};

/// Whether the interpreter is an option of the verb.
bool is_option_of(const Interpreter& interpreter, const std::string& verb);

/// Adds the options of the verb.
void add_interpreter_options(CLI::App& verb, InterpretArguments& arguments,
                             const Interpreter& interpreter);

}  // namespace slalom
