// SPDX-License-Identifier: BSD-3-Clause
#include "interpret.h"
#include "output.h"
#include "shard_tables.h"
#include "warnings.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_files.h>
#include <slalom/results/privileged.h>
#include <slalom/tables/analysis_input.h>

#include <algorithm>
#include <memory>

namespace slalom {
namespace {

/// `--csv` without a file, or with results, selects CSV output; with any other file, that
/// file is the CSV input.
void resolve_csv_option(InterpretArguments& arguments) {
  arguments.csv = arguments.csv_file.empty() || is_result_input(arguments.csv_file);
  if (!arguments.csv_file.empty()) {
    arguments.files.insert(arguments.files.begin(), arguments.csv_file);
  }
}

/// Whether the files are tables of one campaign, such as one for each method.
bool are_parts(const std::vector<std::string>& files, const Interpreter& interpreter) {
  return interpreter.max_results == 1 && files.size() > 1 &&
         std::none_of(files.begin(), files.end(), is_result_input);
}

std::vector<ResultTable> read_inputs(const InterpretArguments& arguments,
                                     const Interpreter& interpreter) {
  const bool joined = are_parts(arguments.files, interpreter);
  require_number_of_results(interpreter, joined ? 1 : arguments.files.size());
  const auto columns = requested_columns(arguments.request, interpreter);
  const CsvColumnOptions& options = arguments.table;
  std::vector<ResultTable> results;
  if (joined) {
    results.push_back(read_analysis_tables(arguments.files, options));
    warn_of_missing(results[0].source, results[0]);
    return results;
  }
  for (const std::string& file : arguments.files) {
    results.push_back(read_analysis_input(file, columns, file == arguments.csv_file, options));
    warn_of_missing(file, results.back());
  }
  unify_kinds(results);
  return results;
}

/// Begins the remarks of interpretations that count outcomes with reasons of methods' failures.
void explain_method_failures(Interpretation& found, const std::vector<ResultTable>& results,
                             const InterpretArguments& arguments, const Interpreter& interpreter) {
  if (!contains({"summary", "table", "failures"}, interpreter.id)) return;
  MethodFailures failures;
  add_method_failures(results[0], arguments.files[0], failures);
  const std::string method = marked_name(results[0], arguments.request.method);
  const auto lines = method.empty() ? failures.lines() : failures.lines_of(method);
  found.remarks.insert(found.remarks.begin(), lines.begin(), lines.end());
}

Interpretation interpret(const InterpretArguments& arguments, const Interpreter& interpreter) {
  if (auto tables = tables_of_shards(arguments, interpreter)) return std::move(*tables);
  std::vector<ResultTable> results = read_inputs(arguments, interpreter);
  AnalysisQuery query = make_query(arguments.request, interpreter, results[0]);
  query.rows = resolve_indexes(std::move(query.rows), arguments.scenarios);
  AnalysisOptions& analysis = query.comparison.analysis;
  analysis.run_ids = arguments.json;
  analysis.medians = !arguments.csv || interpreter.id != "table";
  query.summary = !arguments.csv && !arguments.json;
  Interpretation found = interpret(interpreter, results, std::move(query));
  explain_method_failures(found, results, arguments, interpreter);
  return found;
}

/// Chooses the format by the name of the output where no flag does.
void choose_format(InterpretArguments& a) {
  if (a.csv || a.json || a.latex || a.html) return;
  a.csv = ends_with(a.output, ".csv");
  a.json = ends_with(a.output, ".json");
  a.latex = ends_with(a.output, ".tex");
  a.html = ends_with(a.output, ".html");
  a.markdown = ends_with(a.output, ".md");
}

void interpret_verb(const InterpretArguments& arguments, const Interpreter& interpreter) {
  Interpretation found = interpret(arguments, interpreter);
  // These formats are of plain tables.
  const bool is_document = arguments.latex || arguments.html || arguments.markdown;
  if (arguments.methods_as_columns || is_document) put_methods_in_columns(found);
  print_or_write(arguments.csv        ? render_csv(found)
                 : arguments.json     ? render_json(found)
                 : arguments.latex    ? render_latex(found)
                 : arguments.markdown ? render_markdown(found)
                 : arguments.html
                     ? render_html(found, interpreter.id + ": " + join(arguments.files, ", "))
                     : render_text(found),
                 arguments.output);
  if (!found.passed) throw job_error("gate", "failed", "differences within their limits");
}

void define_verb(CLI::App& app, const Interpreter& interpreter) {
  auto arguments = std::make_shared<InterpretArguments>();
  CLI::App* verb = app.add_subcommand(interpreter.id, interpreter.help);
  add_interpreter_options(*verb, *arguments, interpreter);
  verb->callback([arguments, &interpreter, verb] {
    if (verb->count("--csv") > 0) resolve_csv_option(*arguments);
    choose_format(*arguments);
    const Interpreter* chosen = &interpreter;
    for (const Interpreter& other : all_interpreters())
      if (is_option_of(other, interpreter.id) && verb->count("--" + other.id) > 0) chosen = &other;
    interpret_verb(*arguments, *chosen);
  });
}

/// Answers the name of an option as a verb.
void define_former_verb(CLI::App& app, const Interpreter& interpreter) {
  CLI::App* verb = app.add_subcommand(interpreter.id, interpreter.help)->group("");
  verb->allow_extras()->set_help_flag();
  verb->callback([&interpreter] {
    throw usage_error(interpreter.id, "is now an option",
                      "slalom-analyze " + interpreter.verb + " --" + interpreter.id);
  });
}

}  // namespace

void define_interpreters(CLI::App& app) {
  for (const Interpreter& interpreter : all_interpreters()) {
    const bool is_verb = interpreter.verb == interpreter.id;
    (is_verb ? define_verb : define_former_verb)(app, interpreter);
  }
}

}  // namespace slalom
