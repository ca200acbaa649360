// SPDX-License-Identifier: BSD-3-Clause
#include "quick.h"

#include <slalom/core/text.h>
#include <slalom/io/read_results.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

/// The mean success of each scenario in which the method has a value, by hash.
std::map<std::string, double> success_by_scenario(const ResultTable& runs, std::size_t method) {
  const ValueColumn& success = *find_metric(runs, "success");
  std::map<std::string, std::pair<double, double>> sums;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (runs.method[run] != method || success.is_na(run)) continue;
    auto& [sum, count] = sums[runs.scenario_hashes[runs.scenario[run]]];
    sum += success.number(run);
    ++count;
  }
  std::map<std::string, double> means;
  for (const auto& [hash, sum] : sums) means[hash] = sum.first / sum.second;
  return means;
}

/// None if the method has no value in a stratum.
std::optional<StratifiedRate> estimate(const QuickSample& sample,
                                       const std::map<std::string, double>& success,
                                       double confidence) {
  Allocation known;
  std::vector<double> successes;
  for (std::size_t i = 0; i < sample.strata.size(); ++i) {
    known.push_back(0);
    successes.push_back(0);
    for (std::size_t k = 0; k < sample.sampled[i]; ++k) {
      const auto found = success.find(sample.hashes[sample.strata[i][k]]);
      if (found == success.end()) continue;
      ++known.back();
      successes.back() += found->second;
    }
    if (known.back() == 0) return std::nullopt;
  }
  return stratified_rate(sample.strata, known, successes, confidence);
}

/// ", rank 3 to 5": 1 more than the shipped methods that are better than the interval, to 1 more
/// than those that are better than its lower end. A method is not compared with itself.
std::string rank_text(const QuickSample& sample, const std::string& method,
                      const Interval& interval) {
  if (sample.shipped.empty()) return "";
  std::size_t best = 1, worst = 1;
  for (const auto& [name, rate] : sample.shipped) {
    if (name == method) continue;
    best += rate > interval.high ? 1 : 0;
    worst += rate > interval.low ? 1 : 0;
  }
  return ", rank " + std::to_string(best) + (worst > best ? " to " + std::to_string(worst) : "");
}

}  // namespace

std::string quick_answer(const QuickSample& sample, const std::string& results_path,
                         double confidence) {
  ResultTable runs = read_results(results_path, {{"success"}});
  const std::vector<std::string> names = runs.methods;
  mark_privileged(runs);
  std::string text = "Success over all " + std::to_string(sample.hashes.size()) +
                     " scenarios, estimated from " + std::to_string(sample.size()) +
                     " of them, stratified by " + sample.stratified_by + "; " +
                     format_number(100 * confidence) + " % intervals\n";
  std::size_t width = 0;
  for (const std::string& name : runs.methods) width = std::max(width, name.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += runs.methods[i] + std::string(width + 2 - runs.methods[i].size(), ' ');
    const auto found = estimate(sample, success_by_scenario(runs, i), confidence);
    text += found ? format_fixed(found->rate, 2) + " [" + format_fixed(found->interval.low, 2) +
                        ", " + format_fixed(found->interval.high, 2) + "]" +
                        rank_text(sample, names[i], found->interval)
                  : "no estimate: no run with an outcome in a stratum";
    text += "\n";
  }
  if (!sample.shipped.empty())
    text += "The ranks are those among the " + std::to_string(sample.shipped.size()) +
            " shipped methods, for the robot and the times of configs/baselines.ini.\n";
  return text;
}

}  // namespace slalom
