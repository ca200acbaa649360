#include "interpret.h"

#include <slalom/analysis/analysis_section.h>
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_columns.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>
#include <iostream>
#include <memory>

namespace slalom {
namespace {

/// What the verbs take from the command line.
struct InterpretArguments {
  std::vector<std::string> files, gates;
  std::string rows, columns, method, baseline, parameter, values, output, gate_on = "estimate";
  std::string csv_file, up, down, scenarios;
  double confidence = 0, relevant = 0, power = 0.8;
  bool csv = false, json = false, allow_differences = false;
};

std::vector<std::string> ids_of(const std::string& text) {
  std::vector<std::string> ids;
  for (const std::string& id : split(text, ',')) {
    if (!id.empty()) ids.push_back(id);
  }
  return ids;
}

/// `--csv` alone wants CSV out; with a file that is no result file it is one to read.
void settle_csv(InterpretArguments& arguments, bool given) {
  if (!given) return;
  const std::string file = arguments.csv_file;
  if (!file.empty() && !is_database(file)) {
    arguments.files.insert(arguments.files.begin(), file);
    return;
  }
  arguments.csv = true;
  if (!file.empty()) arguments.files.insert(arguments.files.begin(), file);
}

AnalysisSection campaign_wishes(const Manifest& manifest) {
  const auto text = manifest.find("campaign.ini");
  if (text == manifest.end()) return {};
  return read_options<AnalysisSection>(IniFile::from_text(text->second, "campaign.ini"),
                                       "analysis");
}

std::vector<std::string> values_asked_for(const InterpretArguments& arguments,
                                          const Interpreter& interpreter) {
  std::vector<std::string> ids = ids_of(arguments.columns);
  for (const std::string& gate : arguments.gates) ids.push_back(parse_gate(gate).metric);
  for (const std::string& id : interpreter.further_metrics()) ids.push_back(id);
  if (arguments.rows.empty()) return ids;
  for (const BinSpec& spec : parse_bin_specs(arguments.rows)) {
    if (spec.kind != BinSpec::Kind::All) ids.push_back(spec.descriptor);
  }
  return ids;
}

/// Only what is asked for is read, where the command line says all of it.
RunColumns load(const std::string& path, const InterpretArguments& arguments,
                const Interpreter& interpreter) {
  if (!is_database(path)) {
    const bool is_csv = path.size() > 4 && path.substr(path.size() - 4) == ".csv";
    if (!is_csv && path != arguments.csv_file) return read_run_columns(path);  // says what is wrong
    return columns_from_csv(read_file(path), path, {ids_of(arguments.up), ids_of(arguments.down)});
  }
  const bool said =
      !arguments.rows.empty() && (!arguments.columns.empty() || !arguments.gates.empty());
  if (!said || interpreter.needs_descriptors()) return read_run_columns(path);
  return read_run_columns(path, values_asked_for(arguments, interpreter));
}

/// Indexes become the edges that the list has under their names.
std::vector<BinSpec> with_indexes(std::vector<BinSpec> specs, const std::string& list_path) {
  for (BinSpec& spec : specs) {
    if (spec.kind != BinSpec::Kind::Index) continue;
    const std::string where = "rows '" + spec.descriptor + ":@" + spec.index + "'";
    if (list_path.empty()) {
      throw usage_error(where, "no scenario list to take the index from", "--scenarios LIST");
    }
    const ListIndex index = ScenarioList::open(list_path).index(spec.index);
    if (index.descriptor != spec.descriptor) {
      throw usage_error(where, "the index is of " + index.descriptor,
                        index.descriptor + ":@" + spec.index);
    }
    spec.kind = BinSpec::Kind::Edges;
    spec.edges = index.edges;
  }
  return specs;
}

std::vector<BinSpec> rows_of(const InterpretArguments& arguments, const RunColumns& table,
                             const AnalysisSection& wishes) {
  if (!arguments.rows.empty()) return parse_bin_specs(arguments.rows);
  if (!wishes.rows.empty()) return parse_bin_specs(wishes.rows);
  return parse_bin_specs(find_descriptor(table, "density") != nullptr ? "density:q4" : "all");
}

/// Those asked for, else those of the interpreter that the results have; the campaign's wishes
/// count for tables.
std::vector<std::string> metrics_of(const InterpretArguments& arguments, const RunColumns& table,
                                    const AnalysisSection& wishes, const Interpreter& interpreter) {
  if (!arguments.columns.empty()) return ids_of(arguments.columns);
  if (!arguments.gates.empty()) return {};
  const bool tables = interpreter.id() == "table" || interpreter.id() == "summary";
  if (tables && !wishes.columns.empty()) return ids_of(wishes.columns);
  std::vector<std::string> metrics;
  for (const std::string& id : interpreter.default_metrics()) {
    if (find_metric(table, id) != nullptr) metrics.push_back(id);
  }
  if (metrics.empty()) metrics.push_back(table.metrics.front().info().id);
  return metrics;
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : ids_of(text)) {
    double number = 0;
    if (!parse_number(part, number)) {
      throw usage_error("--values", "'" + part + "' is no number", "numbers, comma separated");
    }
    numbers.push_back(number);
  }
  return numbers;
}

Question question_of(const InterpretArguments& arguments, const RunColumns& table,
                     const Interpreter& interpreter) {
  const AnalysisSection wishes = campaign_wishes(table.manifest);
  Question question;
  question.rows = with_indexes(rows_of(arguments, table, wishes), arguments.scenarios);
  question.metrics = metrics_of(arguments, table, wishes, interpreter);
  question.method = arguments.method;
  question.baseline = arguments.baseline;
  question.parameter = arguments.parameter;
  question.values = numbers_of(arguments.values);
  question.allow_differences = arguments.allow_differences;
  for (const std::string& gate : arguments.gates) question.gates.push_back(parse_gate(gate));
  question.gate_on = arguments.gate_on == "interval" ? GateOn::Interval : GateOn::Estimate;
  question.comparison.analysis.confidence =
      arguments.confidence > 0 ? arguments.confidence : wishes.confidence;
  if (arguments.relevant > 0) question.comparison.relevant = arguments.relevant;
  question.comparison.power = arguments.power;
  return question;
}

std::vector<RunColumns> load_all(const InterpretArguments& arguments,
                                 const Interpreter& interpreter) {
  const std::size_t n = arguments.files.size();
  if (n < interpreter.fewest_results() || n > interpreter.most_results()) {
    throw usage_error(interpreter.id(), std::to_string(n) + " files",
                      interpreter.most_results() == 1
                          ? "one result file; slalom-simulate merge joins shards of a campaign"
                          : "from " + std::to_string(interpreter.fewest_results()) + " to " +
                                std::to_string(interpreter.most_results()) + " result files");
  }
  std::vector<RunColumns> results;
  for (const std::string& file : arguments.files) {
    results.push_back(load(file, arguments, interpreter));
  }
  return results;
}

/// Cross tables have forms of their own, with the summary above them.
std::string cross_tables_text(const RunColumns& table, const Question& question,
                              const InterpretArguments& arguments) {
  AnalysisOptions options = question.comparison.analysis;
  const bool text = !arguments.csv && !arguments.json;
  if (text && question.method.empty()) {
    return render_tables_text(table, question.rows, question.metrics, options.confidence);
  }
  options.run_ids = arguments.json;
  const auto tables =
      build_cross_tables(table, question.rows, question.metrics, options, question.method);
  if (arguments.csv) return render_csv(tables);
  if (arguments.json) return render_json(tables);
  std::string joined;
  for (const CrossTable& cross : tables) {
    joined += (joined.empty() ? "" : "\n\n") + render_cross_table_text(cross);
  }
  return joined;
}

void print_or_write(const std::string& text, const std::string& output) {
  if (output.empty() || output == "-") {
    std::cout << text;
  } else {
    write_file_atomically(output, text);
  }
}

void interpret_verb(const InterpretArguments& arguments, const Interpreter& interpreter) {
  const std::vector<RunColumns> results = load_all(arguments, interpreter);
  const Question question = question_of(arguments, results[0], interpreter);
  if (interpreter.id() == "table") {
    print_or_write(cross_tables_text(results[0], question, arguments), arguments.output);
    return;
  }
  const Interpretation found = interpreter.interpret(results, question);
  print_or_write(arguments.csv    ? render_csv(found)
                 : arguments.json ? render_json(found)
                                  : render_text(found),
                 arguments.output);
  if (!found.passed) throw job_error("gate", "failed", "differences within their limits");
}

void add_choice_options(CLI::App& verb, InterpretArguments& a) {
  verb.add_option("--rows", a.rows,
                  "Bins of a scenario descriptor or metric: all, ID:EDGE,EDGE,..., ID:COUNT (equal "
                  "width), ID:qCOUNT (as many scenarios each) or ID:@INDEX; several separated by "
                  "';'");
  verb.add_option("--scenarios", a.scenarios, "Scenario list that has the indexes of --rows");
  verb.add_option("--columns,--metric", a.columns, "Metric ids, comma separated");
  verb.add_option("--method", a.method, "Only this method");
  verb.add_option("--confidence", a.confidence, "Of intervals, e.g. 0.95; tests take the rest")
      ->check(CLI::Range(0.5, 0.9999));
  verb.add_option("--up", a.up, "CSV: columns of which more is better");
  verb.add_option("--down", a.down, "CSV: columns of which less is better");
}

void add_comparison_options(CLI::App& verb, InterpretArguments& a) {
  verb.add_option("--relevant", a.relevant,
                  "Difference that matters (default: 0.05 of rates, else 5 % of the mean)")
      ->check(CLI::PositiveNumber);
  verb.add_option("--power", a.power, "With which it is to be shown")
      ->check(CLI::Range(0.5, 0.999))
      ->capture_default_str();
}

void add_special_options(CLI::App& verb, InterpretArguments& a, const std::string& id) {
  if (id == "compare") {
    verb.add_option("--baseline", a.baseline, "Compare the other methods with this one");
    verb.add_option("--gate", a.gates,
                    "Exit status 1 unless METRIC OP NUMBER holds for the paired difference, e.g. "
                    "\"success >= -0.02\"; may be given again");
    verb.add_option("--gate-on", a.gate_on, "Number that has to keep to the limit")
        ->check(CLI::IsMember({"estimate", "interval"}))
        ->capture_default_str();
  }
  if (id == "robustness") {
    verb.add_option("--parameter", a.parameter, "SECTION.KEY of the campaigns' .ini");
    verb.add_option("--values", a.values, "Its values, one a file, comma separated");
    verb.add_flag("--allow-differences", a.allow_differences,
                  "The campaigns may differ in more than the parameter");
  }
  if (id == "compare" || id == "robustness") add_comparison_options(verb, a);
}

void define_verb(CLI::App& app, std::shared_ptr<Interpreter> interpreter) {
  auto arguments = std::make_shared<InterpretArguments>();
  CLI::App* verb = app.add_subcommand(interpreter->id(), interpreter->help());
  verb->add_option("results", arguments->files, "Result files (.results), or tables (.csv)");
  add_choice_options(*verb, *arguments);
  add_special_options(*verb, *arguments, interpreter->id());
  CLI::Option* csv = verb->add_option("--csv", arguments->csv_file,
                                      "Print CSV; with a CSV file: read that instead of results")
                         ->expected(0, 1);
  verb->add_flag("--json", arguments->json, "Print JSON, with the ids of runs");
  verb->add_option("-o,--output", arguments->output, "File to write instead of standard output");
  verb->callback([arguments, interpreter, csv] {
    settle_csv(*arguments, csv->count() > 0);
    interpret_verb(*arguments, *interpreter);
  });
}

}  // namespace

void define_interpreters(CLI::App& app) {
  for (auto& interpreter : all_interpreters()) {
    define_verb(app, std::shared_ptr<Interpreter>(std::move(interpreter)));
  }
}

}  // namespace slalom
