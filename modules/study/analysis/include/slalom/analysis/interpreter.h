// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/data_table.h>
#include <slalom/analysis/gate.h>
#include <slalom/analysis/paired_comparison.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Parameters of an analysis. Each interpreter uses those that apply to it.
struct AnalysisQuery {
  std::vector<BinSpec> rows;
  std::vector<std::string> metrics;  ///< ids
  std::string method;                ///< restricts to one method, ranked among all; empty: all
  std::string baseline;              ///< compare: the reference of all comparisons
  std::string parameter;             ///< robustness: "sensor.noise_sigma"
  std::vector<double> values;        ///< robustness: of the parameter, one per file
  bool summary = true;               ///< table: with the summary of all methods
  std::vector<Gate> gates;           ///< compare
  GateOn gate_on = GateOn::Estimate;
  ComparisonOptions comparison;  ///< includes confidence and seed of all analyses
};

/// The result of an interpreter: tables of values, and conclusions as text.
struct Interpretation {
  std::vector<DataTable> tables;     ///< exact and complete, with the ids of runs
  std::vector<DataTable> views;      ///< condensed for display; empty: `tables`
  std::vector<std::string> remarks;  ///< sentences
  bool passed = true;                ///< false: a gate failed
  /// Instead of `tables`: cross tables, which have formats of their own (table_text.h and
  /// table_export.h), with a summary above them in text.
  std::optional<std::vector<CrossTable>> cross_tables = std::nullopt;
  std::optional<SummaryTable> summary = std::nullopt;
  std::string footnote = "";  ///< of the mark of privileged methods; empty if there is none
};

/// An analysis of results: a row of the table in src/interpreters/interpreter_table.cpp. Its values
/// are also available as a plain struct from a separate function (build_summary(),
/// compare_methods(), ...), for reports.
struct Interpreter {
  std::string id;    ///< "ranks"
  std::string verb;  ///< "compare"; if it is not the id, that is an option of the verb: --ranks
  std::string help;  ///< one line
  /// Throws Error (Usage) for ids that are not in the results.
  Interpretation (*interpret)(const std::vector<ResultTable>& results, const AnalysisQuery& query);
  std::size_t min_results = 1, max_results = 1;
  /// Metrics that are used if the query names none.
  std::vector<std::string> default_metrics = {"success"};
  /// Metrics that are used in addition to those of the query, if the results contain them.
  std::vector<std::string> additional_metrics = {};
  bool needs_descriptors = false;  ///< all of them, not only those of the rows
};

const std::vector<Interpreter>& all_interpreters();

/// Interprets results in which the names of privileged methods have their mark, which it adds to
/// them and to the names in the query, and sets the footnote.
Interpretation interpret(const Interpreter& interpreter, std::vector<ResultTable>& results,
                         AnalysisQuery query);

/// The tables as text for a terminal (UTF-8): numbers to four digits, "x [low, high]" for a column
/// with ".low" and ".high"; columns of run ids are omitted.
std::string render_text(const Interpretation& interpretation);
/// {"tables": [...], "remarks": [...], "passed": true}, and "footnote" if there is one.
std::string render_json(const Interpretation& interpretation);
/// The tables as CSV, separated by empty lines; a footnote is a table of its own, the last one.
std::string render_csv(const Interpretation& interpretation);

/// The tables as LaTeX to \input, as render_text() shows them, with the rules of booktabs, each
/// with a caption and a label.
std::string render_latex(const Interpretation& interpretation);
/// The tables as Markdown, as render_text() shows them.
std::string render_markdown(const Interpretation& interpretation);
/// Cross tables of several methods as tables of one metric each: a row per bin, a column per
/// method.
void put_methods_in_columns(Interpretation& interpretation);
/// Address that a field of a table leads to, given the name of its column; empty for plain text.
using FieldAddress =
    std::function<std::string(const std::string& column, const std::string& field)>;
/// One page with the remarks, `figures` (SVG elements) and the tables, in the colors of the report,
/// for A4 paper as well; self-contained but for the addresses.
std::string render_html(const Interpretation& interpretation, const std::string& title,
                        const FieldAddress& address_of = {},
                        const std::vector<std::string>& figures = {});

}  // namespace slalom
