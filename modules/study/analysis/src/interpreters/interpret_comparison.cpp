// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

/// All comparisons of a family are unpaired, or none.
bool is_unpaired(const std::vector<PairedComparison>& family) {
  return !family.empty() && family.front().is_unpaired;
}

std::string title_of(const std::vector<PairedComparison>& family) {
  return std::string(is_unpaired(family) ? "Unpaired" : "Paired") + " comparisons, b against a";
}

DataTable exact_table(const std::vector<PairedComparison>& family) {
  RowTable rows("comparisons", title_of(family));
  for (const PairedComparison& c : family) {
    rows.begin_row();
    rows.add("metric", Field{c.column.info.id});
    rows.add("a", Field{c.a});
    rows.add("b", Field{c.b});
    rows.add("verdict", Field{to_string(c.verdict)});
    rows.add("scenarios", c.scenarios);
    if (c.is_unpaired) {
      rows.add("scenarios_a", c.scenarios_a);
      rows.add("scenarios_b", c.scenarios_b);
      rows.add("runs_without_value", c.runs_without_value);
    }
    rows.add("pairs", c.pairs);
    rows.add("pairs_without_value", c.without_value);
    rows.add("unpaired_runs", c.unpaired);
    rows.add("mean_a", c.mean_a);
    rows.add("mean_b", c.mean_b);
    rows.add("difference", c.difference, c.interval);
    rows.add("ratio", c.ratio, c.ratio_interval);
    rows.add("higher", c.higher);
    rows.add("lower", c.lower);
    rows.add("equal", c.equal);
    rows.add("test", Field{to_string(c.test)});
    rows.add("p", std::optional(c.p));
    rows.add("p_holm", std::optional(c.adjusted_p));
    rows.add("family", c.family);
    rows.add("shift", c.shift ? std::optional(c.shift->estimate) : std::nullopt,
             c.shift ? c.shift->interval : std::nullopt);
    rows.add("superiority", c.superiority);
    rows.add("relevant", std::optional(c.relevant));
    rows.add("power", std::optional(c.power));
    rows.add("required_scenarios", c.required_scenarios);
    rows.add("confidence", std::optional(c.confidence));
  }
  return rows.table();
}

DataTable view_table(const std::vector<PairedComparison>& family) {
  RowTable rows("comparisons", title_of(family));
  const bool has_ratio = std::any_of(family.begin(), family.end(),
                                     [](const PairedComparison& c) { return c.ratio.has_value(); });
  for (const PairedComparison& c : family) {
    rows.begin_row();
    rows.add("metric", Field{c.column.info.id});
    rows.add("a", Field{c.a});
    rows.add("b", Field{c.b});
    if (c.is_unpaired) {
      rows.add("scenarios a", c.scenarios_a);
      rows.add("scenarios b", c.scenarios_b);
    } else {
      rows.add("scenarios", c.scenarios);
    }
    rows.add("mean a", c.mean_a);
    rows.add("mean b", c.mean_b);
    rows.add("b - a", c.difference, c.interval);
    if (has_ratio) rows.add("b / a", c.ratio, c.ratio_interval);
    rows.add("p (Holm)", std::optional(c.adjusted_p));
    rows.add("family", c.family);
    rows.add("verdict", Field{to_string(c.verdict)});
    rows.add("A12", c.superiority);
  }
  return rows.table();
}

std::string gate_sentence(const GateResult& result) {
  std::string text = "gate " + result.gate.text + ": " + result.b + " against " + result.a + ": ";
  if (!result.evaluated) return text + "FAILED: no difference available";
  return text + (result.passed ? "passed" : "FAILED") + ": difference " +
         estimate_text(*result.difference, result.interval, 4) +
         (result.without_value == 0
              ? ""
              : ", no value in " + count_text(result.without_value, "pair") + " of runs");
}

DataTable gate_table(const std::vector<GateResult>& results) {
  RowTable rows("gates", "Gates");
  for (const GateResult& result : results) {
    rows.begin_row();
    rows.add("gate", Field{result.gate.text});
    rows.add("a", Field{result.a});
    rows.add("b", Field{result.b});
    rows.add("difference", result.difference, result.interval);
    rows.add("result", Field{result.passed ? std::string("passed") : std::string("failed")});
  }
  return rows.table();
}

void add_gates(Interpretation& found, const std::vector<PairedComparison>& family,
               const AnalysisQuery& query) {
  const bool other_settings = std::any_of(
      family.begin(), family.end(), [](const PairedComparison& c) { return c.other_settings; });
  if (other_settings && !query.gates.empty())
    throw usage_error("--gate",
                      "the campaigns have other settings (" + join(found.remarks, "; ") + ")",
                      "the same settings, or --despite-settings");
  std::vector<GateResult> results;
  for (const Gate& gate : query.gates) {
    for (GateResult& result : evaluate_gate(gate, family, query.gate_on)) {
      found.passed = found.passed && result.passed;
      found.remarks.push_back(gate_sentence(result));
      results.push_back(std::move(result));
    }
  }
  if (!query.gates.empty()) found.tables.push_back(gate_table(results));
}

/// The metrics of the query and of its gates.
std::vector<std::string> compared_metrics(const AnalysisQuery& query) {
  std::vector<std::string> metrics = query.metrics;
  for (const Gate& gate : query.gates) {
    if (std::find(metrics.begin(), metrics.end(), gate.metric) == metrics.end()) {
      metrics.push_back(gate.metric);
    }
  }
  return metrics;
}

std::vector<PairedComparison> family_of(const std::vector<ResultTable>& results,
                                        const AnalysisQuery& query) {
  const std::vector<std::string> metrics = compared_metrics(query);
  ComparisonOptions options = query.comparison;
  options.unpaired = query.gates.empty();  // these are of the change on the same scenarios
  if (results.size() == 1) {
    return compare_methods(results[0], metrics, query.baseline, options, query.method);
  }
  if (!query.baseline.empty()) {
    throw usage_error("--baseline", "not allowed with two result files (the first is the baseline)",
                      "one result file");
  }
  return compare_results(results[0], results[1], metrics, options, query.method);
}

/// Names the methods of one file only, which no gate is about.
void add_absent_methods(const ResultTable& in, const ResultTable& other, Interpretation& found) {
  if (in.methods.size() == 1 && other.methods.size() == 1) return;  // compared under their names
  for (const std::string& method : in.methods)
    if (!contains(other.methods, method))
      found.remarks.push_back(method + ": not compared, as " + other.source + " has no runs of it");
}

}  // namespace

Interpretation interpret_comparison(const std::vector<ResultTable>& results,
                                    const AnalysisQuery& query) {
  const std::vector<PairedComparison> family = family_of(results, query);
  Interpretation found;
  found.tables = {exact_table(family)};
  found.views = {view_table(family)};
  found.remarks = difference_sentences(results);
  if (is_unpaired(family))
    found.remarks.emplace_back(
        "unpaired: no scenario and repetition has runs of both sides, so that differences between "
        "their scenarios count as differences between the methods");
  for (const PairedComparison& c : family) found.remarks.push_back(verdict_sentence(c));
  if (results.size() == 2) {
    add_absent_methods(results[0], results[1], found);
    add_absent_methods(results[1], results[0], found);
    for (const PairedComparison& c : family) {
      if (c.is_unpaired || c.unpaired == 0 || c.column.info.id != family.front().column.info.id)
        continue;
      found.remarks.push_back(c.b + " against " + c.a + ": " + count_text(c.unpaired, "run") +
                              " without a partner left out");
    }
  }
  add_gates(found, family, query);
  return found;
}

}  // namespace slalom
