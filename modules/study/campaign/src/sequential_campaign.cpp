// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_pool.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/campaign/sequential_campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>
#include <slalom/metrics/metric.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

std::size_t precision_batch(std::size_t taken) {
  return taken == 0 ? kFirstBatch : (taken + 1) / 2;
}

std::size_t decision_batch(std::size_t taken) {
  return std::max(kFirstBatch, taken / 10);
}

void expect_known(const std::string& name, const std::vector<std::string>& known,
                  const std::string& problem) {
  if (!contains(known, name))
    throw usage_error("--until", "'" + name + "' " + problem, expected_name(name, known));
}

/// Throws for ids that the campaign does not compute.
void check_metric(const std::string& id, const CampaignOptions& options) {
  std::vector<std::string> metrics = options.metrics;
  if (!contains(metrics, "success")) metrics.emplace_back("success");
  expect_known(id, metrics, "is not computed by this campaign");
}

void check_rows(const BinSpec& rows, const CampaignOptions& options) {
  if (rows.kind == BinSpec::Kind::All) return;
  expect_known(rows.descriptor, options.descriptors, "is not computed by this campaign");
  if (rows.kind == BinSpec::Kind::Index)
    throw usage_error("--until", "bins of an index, @" + rows.index,
                      "the edges of its bins, such as density:0,0.1,0.2");
}

void check_methods_of(const DecisionRule& rule, const std::vector<NamedMethod>& methods) {
  std::vector<std::string> names;
  for (const NamedMethod& method : methods) names.push_back(method.name);
  for (const std::string& name : {rule.method, rule.reference})
    expect_known(name, names, "is not a method of this campaign");
  if (rule.method == rule.reference)
    throw usage_error("--until", "'" + rule.method + "' is compared with itself", "two methods");
}

/// The columns that a look requires.
std::vector<std::string> ids_of(const PrecisionRule& rule) {
  if (rule.rows.kind == BinSpec::Kind::All) return {rule.metric};
  return {rule.metric, rule.rows.descriptor};
}

/// Whether each bin is open: some method has not reached the required precision.
std::vector<bool> open_bins(const std::vector<PrecisionCell>& cells, std::size_t bins) {
  std::vector<bool> open(bins, false);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].reached) open[i % bins] = true;
  return open;
}

/// Result of an interim analysis.
struct InterimAnalysis {
  std::vector<bool> open;  ///< by bin: the rule is not yet met
  std::string text;
};

/// The interim analyses of a rule; the scenarios so far are given by their hashes in the order of
/// the batches.
class InterimAnalyses {
 public:
  InterimAnalyses(const CampaignRecorder& recorder, double confidence) : recorder_(recorder) {
    analysis_.confidence = confidence;
  }

  std::size_t count() const { return count_; }
  std::size_t runs() const { return runs_; }

  InterimAnalysis analyze(const PrecisionRule& rule, const ScenarioPool& pool,
                          const std::vector<std::string>& hashes) {
    const auto cells = precision_cells(read(ids_of(rule), hashes), rule, analysis_);
    const auto reached = std::count_if(cells.begin(), cells.end(),
                                       [](const PrecisionCell& cell) { return cell.reached; });
    return {open_bins(cells, pool.bins()), render_precision_text(rule, cells) +
                                               std::to_string(reached) + " of " +
                                               std::to_string(cells.size()) + " cells reached"};
  }

  InterimAnalysis analyze(const DecisionRule& rule, const ScenarioPool& pool,
                          const std::vector<std::string>& hashes) {
    const auto advantages = scenario_advantages(read({rule.metric}, hashes), rule, hashes);
    if (rule.in_pool && advantages.size() < hashes.size())
      throw usage_error("--until",
                        "'" + rule.metric + "' has no value in " +
                            std::to_string(hashes.size() - advantages.size()) + " of " +
                            count_text(hashes.size(), "scenario"),
                        "a metric with a value in each for \"in the pool\", such as success");
    const DecisionState state = decide(rule, advantages, analysis_.confidence, pool.scenarios());
    return {{state.decision == Decision::Open}, decision_sentence(rule, state) + "\nended"};
  }

 private:
  const CampaignRecorder& recorder_;
  AnalysisOptions analysis_;
  std::size_t count_ = 0, runs_ = 0;

  ResultTable read(const std::vector<std::string>& ids, const std::vector<std::string>& hashes) {
    ResultTable results = read_results(recorder_.file().path(), ids);
    const std::set<std::string> analyzed(hashes.begin(), hashes.end());
    std::vector<bool> kept;  // a file that is continued holds runs of later batches
    for (const std::string& hash : results.scenario_hashes)
      kept.push_back(analyzed.count(hash) > 0);
    keep_runs_in(results, kept);
    ++count_;
    runs_ = results.size();
    return results;
  }
};

std::vector<Scenario> in_random_order(std::vector<Scenario> scenarios, std::uint64_t seed) {
  std::vector<std::string> hashes;
  for (const Scenario& scenario : scenarios) hashes.push_back(scenario.hash());
  std::vector<Scenario> ordered;
  for (const std::size_t i : random_order(hashes, seed)) ordered.push_back(std::move(scenarios[i]));
  return ordered;
}

template <typename Rule>
SequentialReport run_in_batches(CampaignRecorder& recorder, const Rule& rule, ScenarioPool& pool,
                                std::size_t max_runs, double confidence,
                                const Execution& execution) {
  SequentialReport report;
  report.complete = !execution.is_interrupted();
  InterimAnalyses analyses(recorder, confidence);
  InterimAnalysis last{std::vector<bool>(pool.bins(), true), "ended"};
  std::string stop_reason;
  std::vector<std::string> taken;
  while (report.complete && stop_reason.empty()) {
    const std::vector<Scenario> batch = pool.next_batch(last.open);
    if (batch.empty()) {
      stop_reason = "no scenarios left in bins that still need runs";
      break;
    }
    report.complete = recorder.run(batch, execution);
    if (!report.complete) break;
    for (const Scenario& scenario : batch) taken.push_back(scenario.hash());
    last = analyses.analyze(rule, pool, taken);
    report.reached = std::find(last.open.begin(), last.open.end(), true) == last.open.end();
    if (report.reached) stop_reason = "the rule is met";
    if (stop_reason.empty() && max_runs > 0 && analyses.runs() >= max_runs)
      stop_reason = "maximum number of runs reached";
  }
  report.runs = analyses.runs();
  report.text = last.text + " after " + count_text(analyses.runs(), "run") + " and " +
                count_text(analyses.count(), "look") + ": " + stop_reason + "\n";
  return report;
}

}  // namespace

StoppingRule parse_stopping_rule(const std::string& text, std::size_t max_runs,
                                 const CampaignOptions& options,
                                 const std::vector<NamedMethod>& methods) {
  if (text.find("compare") != std::string::npos) {
    const DecisionRule rule =
        parse_decision_rule(text, [](const std::string& id) { return metric(id).info.range; });
    check_metric(rule.metric, options);
    check_methods_of(rule, methods);
    return {text, rule, max_runs};
  }
  const PrecisionRule rule = parse_precision_rule(text);
  check_metric(rule.metric, options);
  check_rows(rule.rows, options);
  return {text, rule, max_runs};
}

std::vector<std::size_t> random_order(const std::vector<std::string>& hashes, std::uint64_t seed) {
  std::vector<std::pair<std::string, std::size_t>> keys;
  for (std::size_t i = 0; i < hashes.size(); ++i)
    keys.emplace_back(Hasher().add("order of a pool").add(seed).add(hashes[i]).hex(), i);
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  for (const auto& [key, index] : keys) order.push_back(index);
  return order;
}

SequentialReport run_until(CampaignRecorder& recorder, const StoppingRule& rule,
                           std::vector<Scenario> scenarios, double confidence,
                           const Execution& execution) {
  scenarios = in_random_order(std::move(scenarios), recorder.options().seed);
  if (const auto* decision = std::get_if<DecisionRule>(&rule.rule)) {
    ScenarioPool pool(std::move(scenarios), decision_batch);
    return run_in_batches(recorder, *decision, pool, rule.max_runs, confidence, execution);
  }
  PrecisionRule precision = std::get<PrecisionRule>(rule.rule);
  ScenarioPool pool(std::move(scenarios), precision_batch, precision.rows, recorder.options(),
                    execution);
  return run_in_batches(recorder, precision, pool, rule.max_runs, confidence, execution);
}

}  // namespace slalom
