// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/interpreter.h>
#include <slalom/results/privileged.h>
#include <slalom/results/repeatability.h>

namespace slalom {

using Interpret = Interpretation(const std::vector<ResultTable>& results,
                                 const AnalysisQuery& query);

// Each in its own file of this folder.
Interpret interpret_summary, interpret_cross_tables, interpret_map, interpret_comparison,
    interpret_ranks, interpret_profile, interpret_completion, interpret_failures,
    interpret_validity, interpret_difficulty, interpret_robustness, interpret_history;

namespace {
std::vector<std::string> table_metrics() {
  return {"success", "optimality", "safety"};
}
}  // namespace

const std::vector<Interpreter>& all_interpreters() {
  static const std::vector<Interpreter> all = {
      {"summary",
       "summary",
       "Summarize all runs of each method: numbers, and a sentence",
       interpret_summary,
       1,
       1,
       table_metrics(),
       {"success"}},
      {"table", "table", "Print a summary per method and cross tables of bins by metrics",
       interpret_cross_tables, 1, 1, table_metrics()},
      {"map", "table", "Map one metric over the bins of two descriptors: --rows 'A:4;B:4'",
       interpret_map},
      {"compare", "compare",
       "Compare methods, or two result files (B against A), on the same scenarios",
       interpret_comparison, 1, 2},
      {"ranks", "compare",
       "Rank all methods within scenarios: Friedman's test, critical differences", interpret_ranks},
      {"profile",
       "compare",
       "Performance profiles: how often each method is within a ratio of the best",
       interpret_profile,
       1,
       1,
       {"time_to_goal"}},
      {"completion",
       "completion",
       "Completion curves: runs that reached the goal over time, with failures as competing risks",
       interpret_completion,
       1,
       1,
       {"time_to_goal", "time"},
       {"path_length", "mean_speed"}},
      {"failures", "table", "Count outcomes by method and by bin", interpret_failures},
      {"validity",
       "difficulty",
       "Rank correlations of descriptors with metrics, and with each other",
       interpret_validity,
       1,
       1,
       {"success", "spl"},
       {},
       true},
      {"difficulty",
       "difficulty",
       "Scale of difficulty: abilities of methods, difficulty of scenarios and its prediction",
       interpret_difficulty,
       1,
       1,
       {"success"},
       {},
       true},
      {"robustness", "history", "Metrics over a swept parameter, with one result file per value",
       interpret_robustness, 2, 1000},
      {"history", "history",
       "What changed over versions or campaigns: new failures, and each metric by result file",
       interpret_history, 2, 1000},
  };
  return all;
}

Interpretation interpret(const Interpreter& interpreter, std::vector<ResultTable>& results,
                         AnalysisQuery query) {
  PrivilegedMethods privileged;
  for (const ResultTable& table : results) privileged.add(privileged_methods(table.manifest));
  for (ResultTable& table : results) {
    mark_privileged(table, privileged);
    for (std::string* name : {&query.method, &query.baseline}) *name = marked_name(table, *name);
  }
  Interpretation found = interpreter.interpret(results, query);
  for (const ResultTable& table : results)
    for (const std::string& note : notes_on_runs(table))
      found.remarks.push_back((results.size() > 1 ? table.source + ": " : "") + note);
  found.footnote = privileged_footnote(privileged);
  return found;
}

}  // namespace slalom
