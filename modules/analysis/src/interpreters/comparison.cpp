#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

DataTable exact_table(const std::vector<PairedComparison>& family) {
  RowTable rows("comparisons", "Paired comparisons, b against a");
  for (const PairedComparison& c : family) {
    rows.begin_row();
    rows.add("metric", Field{c.column.info.id});
    rows.add("a", Field{c.a});
    rows.add("b", Field{c.b});
    rows.add("verdict", Field{to_string(c.verdict)});
    rows.add("scenarios", c.scenarios);
    rows.add("pairs", c.pairs);
    rows.add("pairs_without_value", c.without_value);
    rows.add("unpaired_runs", c.unpaired);
    rows.add("mean_a", c.mean_a);
    rows.add("mean_b", c.mean_b);
    rows.add("difference", c.difference, c.interval);
    rows.add("higher", c.higher);
    rows.add("lower", c.lower);
    rows.add("equal", c.equal);
    rows.add("test", Field{to_string(c.test)});
    rows.add("p", std::optional(c.p));
    rows.add("p_holm", std::optional(c.adjusted_p));
    rows.add("shift", c.shift ? std::optional(c.shift->estimate) : std::nullopt,
             c.shift ? c.shift->interval : std::nullopt);
    rows.add("superiority", c.superiority);
    rows.add("relevant", std::optional(c.relevant));
    rows.add("power", std::optional(c.power));
    rows.add("scenarios_needed", c.scenarios_needed);
    rows.add("confidence", std::optional(c.confidence));
  }
  return rows.table();
}

DataTable view_table(const std::vector<PairedComparison>& family) {
  RowTable rows("comparisons", "Paired comparisons, b against a");
  for (const PairedComparison& c : family) {
    rows.begin_row();
    rows.add("metric", Field{c.column.info.id});
    rows.add("a", Field{c.a});
    rows.add("b", Field{c.b});
    rows.add("scenarios", c.scenarios);
    rows.add("mean a", c.mean_a);
    rows.add("mean b", c.mean_b);
    rows.add("b - a", c.difference, c.interval);
    rows.add("A12", c.superiority);
    rows.add("p (Holm)", std::optional(c.adjusted_p));
    rows.add("verdict", Field{to_string(c.verdict)});
  }
  return rows.table();
}

std::string gate_sentence(const GateResult& result) {
  std::string text = "gate " + result.gate.text + ": " + result.b + " against " + result.a + ": ";
  if (!result.judged) return text + "FAILED: there is no such difference";
  text += std::string(result.passed ? "passed" : "FAILED") + ": difference " +
          format_fixed(*result.difference, 4);
  if (!result.interval) return text;
  return text + " [" + format_fixed(result.interval->low, 4) + ", " +
         format_fixed(result.interval->high, 4) + "]";
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
               const Question& question) {
  std::vector<GateResult> results;
  for (const Gate& gate : question.gates) {
    for (GateResult& result : judge_gate(gate, family, question.gate_on)) {
      found.passed = found.passed && result.passed;
      found.remarks.push_back(gate_sentence(result));
      results.push_back(std::move(result));
    }
  }
  if (!question.gates.empty()) found.tables.push_back(gate_table(results));
}

/// Those asked for, and those of the gates.
std::vector<std::string> compared_metrics(const Question& question) {
  std::vector<std::string> metrics = question.metrics;
  for (const Gate& gate : question.gates) {
    if (std::find(metrics.begin(), metrics.end(), gate.metric) == metrics.end()) {
      metrics.push_back(gate.metric);
    }
  }
  return metrics;
}

std::vector<PairedComparison> family_of(const std::vector<RunColumns>& results,
                                        const Question& question) {
  const std::vector<std::string> metrics = compared_metrics(question);
  if (results.size() == 1) {
    return compare_methods(results[0], metrics, question.baseline, question.comparison);
  }
  if (!question.baseline.empty()) {
    throw usage_error("--baseline", "of two result files the first is the baseline",
                      "one result file");
  }
  return compare_results(results[0], results[1], metrics, question.comparison);
}

class ComparisonInterpreter : public Interpreter {
 public:
  std::string id() const override { return "compare"; }
  std::string help() const override {
    return "Compare methods, or two result files (B against A), on the same scenarios";
  }
  std::size_t most_results() const override { return 2; }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    const std::vector<PairedComparison> family = family_of(results, question);
    Interpretation found;
    found.tables = {exact_table(family)};
    found.views = {view_table(family)};
    for (const PairedComparison& c : family) found.remarks.push_back(verdict_sentence(c));
    if (results.size() == 2) {
      for (const std::string& difference :
           campaign_differences(results[0].manifest, results[1].manifest, {})) {
        found.remarks.push_back("the campaigns differ: " + difference);
      }
      for (const PairedComparison& c : family) {
        if (c.unpaired == 0 || c.column.info.id != family.front().column.info.id) continue;
        found.remarks.push_back(c.b + " against " + c.a + ": " + count_text(c.unpaired, "run") +
                                " without a partner left out");
      }
    }
    add_gates(found, family, question);
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_comparison_interpreter() {
  return std::make_unique<ComparisonInterpreter>();
}

}  // namespace slalom
