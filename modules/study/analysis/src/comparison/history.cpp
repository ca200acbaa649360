// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/history.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace slalom {
namespace {

std::vector<std::string> methods_of(const std::vector<ResultTable>& results,
                                    const std::string& method) {
  std::set<std::string> names;
  for (const ResultTable& result : results)
    names.insert(result.methods.begin(), result.methods.end());
  const std::vector<std::string> all(names.begin(), names.end());
  if (method.empty()) return all;
  if (names.count(method) > 0) return {method};
  throw usage_error("method", "no runs of '" + method + "' in these results",
                    expected_name(method, all));
}

std::optional<PairedComparison> change_of(const Side& before, const Side& now,
                                          const std::string& metric,
                                          const ComparisonOptions& options) {
  PairedComparison change = compare_pair(before, now, metric, options);
  return change.has_partners() ? std::optional(std::move(change)) : std::nullopt;
}

HistoryCurve curve_of(const std::vector<ResultTable>& results, const std::string& method,
                      const std::string& metric, const ComparisonOptions& options) {
  HistoryCurve curve;
  curve.method = method;
  curve.column = resolve_columns(results.front(), {metric})[0];
  std::optional<Side> before;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ResultTable& result = results[i];
    if (std::find(result.methods.begin(), result.methods.end(), method) == result.methods.end())
      continue;
    HistoryPoint point;
    point.result = i;
    const std::uint32_t index = index_of_method(result, method);
    std::vector<std::size_t> runs;
    for (std::size_t run = 0; run < result.size(); ++run)
      if (result.method[run] == index) runs.push_back(run);
    const Side now{&result, method, method + " (" + result.source + ")"};
    point.cell = make_cell(result, runs, require_metric(result, metric), options.analysis);
    if (before) point.change = change_of(*before, now, metric, options);
    before = now;
    curve.points.push_back(std::move(point));
  }
  return curve;
}

void correct_changes(std::vector<HistoryCurve>& curves) {
  std::vector<PairedComparison> family;
  std::vector<PairedComparison*> changes;
  for (HistoryCurve& curve : curves)
    for (HistoryPoint& point : curve.points)
      if (point.change) {
        family.push_back(*point.change);
        changes.push_back(&*point.change);
      }
  finish_families(family);
  for (std::size_t i = 0; i < changes.size(); ++i) *changes[i] = family[i];
}

/// Runs of the last two results, paired by scenario hash, method and repetition.
void add_changed_runs(History& history, const std::vector<ResultTable>& results,
                      const std::vector<std::string>& methods) {
  using Key = std::tuple<std::string, std::string, std::uint32_t>;
  const auto key_of = [](const ResultTable& table, std::size_t run) {
    return Key{table.scenario_hashes[table.scenario[run]], table.methods[table.method[run]],
               table.repetition[run]};
  };
  const ResultTable &before = results[results.size() - 2], &now = results.back();
  const auto end_of = [](const ResultTable& table, std::size_t run) {
    return table.outcomes[table.outcome[run]];
  };
  std::map<Key, std::string> outcomes;
  for (std::size_t run = 0; run < before.size(); ++run)
    outcomes[key_of(before, run)] = end_of(before, run);
  for (std::size_t run = 0; run < now.size(); ++run) {
    const Key key = key_of(now, run);
    const auto partner = outcomes.find(key);
    if (partner == outcomes.end() ||
        std::find(methods.begin(), methods.end(), std::get<1>(key)) == methods.end())
      continue;
    const std::string outcome = end_of(now, run);
    const bool is_told = outcome != kUnknownOutcome && partner->second != kUnknownOutcome;
    ++(is_told ? history.compared_runs : history.untold_runs);
    const ChangedRun changed{results.size() - 1, run, partner->second, outcome};
    if (is_failure(outcome) && partner->second == "success")
      history.new_failures.push_back(changed);
    if (outcome == "success" && is_failure(partner->second))
      history.new_successes.push_back(changed);
  }
}

}  // namespace

History build_history(const std::vector<ResultTable>& results,
                      const std::vector<std::string>& metrics, const ComparisonOptions& options,
                      const std::string& method) {
  if (results.size() < 2)
    throw usage_error("history", "fewer than two result files", "two or more, in their order");
  History history;
  const std::vector<std::string> shown = methods_of(results, method);
  for (const std::string& metric : metrics)
    for (const std::string& name : methods_of(results, ""))
      history.curves.push_back(curve_of(results, name, metric, options));
  correct_changes(history.curves);
  const auto is_hidden = [&](const HistoryCurve& curve) { return !contains(shown, curve.method); };
  history.curves.erase(std::remove_if(history.curves.begin(), history.curves.end(), is_hidden),
                       history.curves.end());
  add_changed_runs(history, results, shown);
  return history;
}

}  // namespace slalom
