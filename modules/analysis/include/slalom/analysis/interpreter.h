#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/data_table.h>
#include <slalom/analysis/gate.h>
#include <slalom/analysis/paired_comparison.h>

#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// What is asked of results. Each interpreter takes the parts that it understands.
struct Question {
  std::vector<BinSpec> rows;
  std::vector<std::string> metrics;  ///< ids
  std::string method;                ///< only this one; empty: all
  std::string baseline;              ///< compare: the others against this one
  std::string parameter;             ///< robustness: "sensor.noise_sigma"
  std::vector<double> values;        ///< robustness: of the parameter, one a file
  bool allow_differences = false;    ///< between the campaigns of several files
  std::vector<Gate> gates;           ///< compare
  GateOn gate_on = GateOn::Estimate;
  ComparisonOptions comparison;  ///< also the confidence and the seed of everything else
};

/// What an interpreter found: tables of values, and what may be claimed of them in words.
struct Interpretation {
  std::vector<DataTable> tables;     ///< exact and complete, with the ids of runs
  std::vector<DataTable> views;      ///< the same for people; empty: `tables`
  std::vector<std::string> remarks;  ///< sentences
  bool passed = true;                ///< false: a gate failed
};

/// One way to read results. Its values are also there as a plain struct from a function of its own
/// (build_summary(), compare_methods(), ...), for reports.
class Interpreter {
 public:
  virtual ~Interpreter() = default;
  virtual std::string id() const = 0;    ///< the verb: "compare"
  virtual std::string help() const = 0;  ///< one line
  virtual std::size_t fewest_results() const { return 1; }
  virtual std::size_t most_results() const { return 1; }
  /// Metrics that are looked at where the question names none.
  virtual std::vector<std::string> default_metrics() const { return {"success"}; }
  /// Metrics that are needed besides those of the question, where the results have them.
  virtual std::vector<std::string> further_metrics() const { return {}; }
  /// Whether all descriptors are needed, not only those of the rows.
  virtual bool needs_descriptors() const { return false; }

  /// Throws Error (Usage) for what is not in the results.
  virtual Interpretation interpret(const std::vector<RunColumns>& results,
                                   const Question& question) const = 0;
};

/// Every interpreter. A new one: a file in src/interpreters, its make function in interpreters.h,
/// and a line in the list in interpreter.cpp.
std::vector<std::unique_ptr<Interpreter>> all_interpreters();

/// Several tables one below the other, for a terminal (UTF-8); numbers to four digits, "x [low,
/// high]" where a column comes with ".low" and ".high"; the columns of run ids left out.
std::string render_text(const Interpretation& interpretation);
/// {"tables": [...], "remarks": [...], "passed": true}.
std::string render_json(const Interpretation& interpretation);
/// The tables as CSV, an empty line between them.
std::string render_csv(const Interpretation& interpretation);

}  // namespace slalom
