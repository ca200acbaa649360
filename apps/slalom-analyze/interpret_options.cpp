// SPDX-License-Identifier: BSD-3-Clause
#include "interpret_options.h"
#include "key_options.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/checks.h>
#include <slalom/app/program.h>
#include <slalom/campaign/campaign_options.h>
#include <slalom/core/available_cores.h>
#include <slalom/descriptors/descriptor.h>

#include <algorithm>

namespace slalom {
namespace {

void add_choice_options(CLI::App& verb, InterpretArguments& a) {
  complete_with(
      verb.add_option(
          "--rows,--by", a.request.rows,
          "Bins of a scenario descriptor or metric: all, ID (quarters), ID:EDGE,EDGE,..., "
          "ID:COUNT (equal width), ID:qCOUNT (quantiles) or ID:@INDEX, such as density:0,0.1,0.2 "
          "or density:q4; several separated by ';'"),
      [](const Words&) { return descriptor_ids(); });
  verb.add_option("--scenarios", a.scenarios, "Scenario list with the indexes of --rows");
  complete_with(
      verb.add_option("--columns,--metric", a.request.metrics, "Metric ids, comma-separated"),
      [](const Words&) { return metric_ids(); });
  complete_with(verb.add_option("--method", a.request.method, "Restrict to this method"),
                known_methods);
  verb.add_option("--confidence", a.request.confidence,
                  "Confidence of intervals, e.g. 0.95; the level of tests is 1 - confidence")
      ->check(in_range(0.5, 0.9999));
  add_key_options(verb, a.table, false);
}

void add_comparison_options(CLI::App& verb, InterpretArguments& a) {
  verb.add_option("--relevant", a.request.relevant,
                  "Smallest difference of interest (default: 0.05 for rates, else 5 % of the mean)")
      ->check(above_zero());
  verb.add_option("--power", a.request.power, "Statistical power for that difference")
      ->check(in_range(0.5, 0.999))
      ->capture_default_str();
}

/// Each thread has a file in memory.
int default_jobs() {
  return std::min(available_cores(), 8);
}

/// Adds the options that are another analysis.
void add_other_interpreters(CLI::App& verb, const std::string& id) {
  std::vector<CLI::Option*> added;
  for (const Interpreter& other : all_interpreters()) {
    if (!is_option_of(other, id)) continue;
    CLI::Option* option = verb.add_flag("--" + other.id, other.help);
    for (CLI::Option* one : added) option->excludes(one);
    added.push_back(option);
  }
}

/// The options of the verb that its other analyses do not use.
void exclude(CLI::App& verb, const std::vector<const char*>& analyses,
             const std::vector<const char*>& options) {
  for (const char* analysis : analyses)
    for (const char* option : options) verb.get_option(analysis)->excludes(verb.get_option(option));
}

void add_special_options(CLI::App& verb, InterpretArguments& a, const std::string& id) {
  if (id == "compare") {
    complete_with(verb.add_option("--baseline", a.request.baseline,
                                  "Compare all other methods with this one"),
                  known_methods);
    complete_with(verb.add_option(
                      "--gate", a.request.gates,
                      "Exit status 1 unless METRIC OP NUMBER holds for the paired difference, e.g. "
                      "\"success >= -0.02\"; repeatable"),
                  [](const Words&) { return metric_ids(); });
    add_choice(verb, "--gate-on", a.request.gate_on, "Quantity that must satisfy the limit")
        ->default_str(to_string(a.request.gate_on));
  }
  if (id == "history") {
    CLI::Option* robustness = verb.get_option("--robustness");
    verb.add_option("--parameter", a.request.parameter,
                    "Swept parameter: SECTION.KEY of the campaigns' .ini")
        ->needs(robustness);
    verb.add_option("--values", a.request.values, "Its values, one per file, comma-separated")
        ->needs(robustness);
  }
  if (id == "table") {
    verb.add_option_function<std::string>(
            "--methods-as",
            [&a](const std::string& text) { a.methods_as_columns = text == "columns"; },
            "What a method is: a table of its own with the metrics as columns (tables), or a "
            "column of a table for each metric (columns)")
        ->check(CLI::IsMember({"tables", "columns"}))
        ->default_str("tables");
    a.jobs = default_jobs();
    add_jobs_option(verb, a.jobs,
                    "Threads that read the shards of a folder (default: the cores, at most 8); "
                    "tables do not depend on their number")
        ->default_str("");
  }
  if (id == "compare" || id == "history") {
    add_comparison_options(verb, a);
    verb.add_flag(
        "--despite-settings", a.request.despite_settings,
        "Compare campaigns that differ in settings of robot, sensors, simulation, people, "
        "limits, references or metrics");
    // Hidden: the name of the output says the same; scripts use them.
    CLI::Option* latex = verb.add_flag("--latex", a.latex, "Print the tables as LaTeX");
    verb.add_flag("--html", a.html, "Print one HTML page")->excludes(latex)->group("");
    latex->group("");
  }
  if (id == "compare")
    exclude(verb, {"--ranks", "--profile"},
            {"--baseline", "--gate", "--gate-on", "--relevant", "--power", "--despite-settings"});
  if (id == "table") {
    exclude(verb, {"--map", "--failures"}, {"--methods-as"});
    exclude(verb, {"--failures"}, {"--columns"});
  }
}

}  // namespace

bool is_option_of(const Interpreter& interpreter, const std::string& verb) {
  return interpreter.verb == verb && interpreter.id != verb;
}

void add_interpreter_options(CLI::App& verb, InterpretArguments& arguments,
                             const Interpreter& interpreter) {
  verb.add_option(
      "results", arguments.files,
      "Result files (.results), folders with the shards of a campaign, or tables (.csv)");
  add_choice_options(verb, arguments);
  add_other_interpreters(verb, interpreter.id);
  add_special_options(verb, arguments, interpreter.id);
  verb.add_option("--csv", arguments.csv_file,
                  "Print CSV; with a CSV file: read it instead of results")
      ->expected(0, 1);
  verb.add_flag("--json", arguments.json, "Print JSON, including run ids");
  verb.add_option("-o,--output", arguments.output,
                  "File to write instead of standard output, in the format of its name: .csv, "
                  ".json, .tex (for \\input), .md, .html (to be read or printed on A4 paper), else "
                  "text");
}

}  // namespace slalom
