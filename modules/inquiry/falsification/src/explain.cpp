// SPDX-License-Identifier: BSD-3-Clause
#include "departure.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/falsification/clusters.h>
#include <slalom/falsification/explain.h>
#include <slalom/metrics/mover_metrics.h>
#include <slalom/simulation/evaluate_trajectory.h>
#include <slalom/statistics/statistics.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace slalom {
namespace {

/// Metrics that say whether, where or when a run ended, as all those about movers and people: they
/// differ between failures and successes by definition.
constexpr std::array kOutcomeMetrics = {
    "success",       "spl",          "soft_spl",     "barn_score_v2",    "par2_time",
    "path_length",   "progress",     "impact_speed", "final_distance",   "closest_distance",
    "min_clearance", "time_to_goal", "time_stopped", "oscillation_count"};

bool follows_from_outcome(const ValueColumn& metric) {
  for (const char* id : kOutcomeMetrics)
    if (metric.info().id == id) return true;
  return metric.wall_clock || contains(mover_metric_ids(), metric.info().id) ||
         contains(people_metric_ids(), metric.info().id);
}

/// The runs of the tested method by scenario.
class TestedRuns {
 public:
  TestedRuns(const ResultTable& runs, const ExaminedFailures& examined) : runs_(runs) {
    for (std::size_t run = 0; run < runs.size(); ++run)
      if (runs.methods[runs.method[run]] == examined.method &&
          runs.repetition[run] == static_cast<std::uint32_t>(examined.repetition))
        by_scenario_[runs.scenario_hashes[runs.scenario[run]]] = run;
  }
  std::size_t at(const std::string& hash) const {
    const auto found = by_scenario_.find(hash);
    if (found == by_scenario_.end()) throw job_error(runs_.source, "no run in scenario " + hash);
    return found->second;
  }
  bool is_success(std::size_t run) const { return runs_.outcomes[runs_.outcome[run]] == "success"; }

 private:
  const ResultTable& runs_;
  std::map<std::string, std::size_t> by_scenario_;
};

class Explainer {
 public:
  Explainer(const ResultFile& file, const ResultTable& runs, const ReportOptions& options,
            const ExaminedFailures& examined)
      : file_(file),
        runs_(runs),
        options_(options),
        examined_(examined),
        failures_(examined.failures),
        confidence_(options.analysis.confidence),
        tested_(runs, examined) {
    for (const ExaminedFailure& failure : failures_) reported_.push_back(reported(failure));
  }

  std::vector<ReportedCluster> clusters() const {
    std::vector<FailureFacts> facts;
    for (const ExaminedFailure& failure : failures_) facts.push_back(facts_of(failure));
    std::vector<ReportedCluster> clusters;
    for (const FailureCluster& cluster : cluster_failures(facts))
      clusters.push_back(explained(cluster));
    return clusters;
  }

 private:
  const ResultFile& file_;
  const ResultTable& runs_;
  const ReportOptions& options_;
  const ExaminedFailures& examined_;
  const std::vector<ExaminedFailure>& failures_;
  double confidence_;
  TestedRuns tested_;
  std::vector<ReportedFailure> reported_;  ///< parallel to the failures

  ReportedFailure reported(const ExaminedFailure& failure) const {
    ReportedFailure report;
    report.run = tested_.at(failure.smallest);
    report.compared = tested_.at(failure.compared);
    report.found = failure.found;
    report.command = failure.command;
    report.departure = departure_of(failure);
    for (const std::string& hash : failure.neighbors)
      if (const std::size_t run = tested_.at(hash); tested_.is_success(run))
        report.neighbors.push_back(run);
    return report;
  }

  /// From the path of the first method, by name, that reaches the goal in the smallest scenario.
  std::string departure_of(const ExaminedFailure& failure) const {
    const std::vector<RunRecord> runs = file_.read_runs(failure.smallest);
    const auto is_tested = [&](const RunRecord& run) {
      return run.method == examined_.method && run.repetition == examined_.repetition;
    };
    const auto tested = std::find_if(runs.begin(), runs.end(), is_tested);
    const auto reference = std::find_if(runs.begin(), runs.end(), [&](const RunRecord& run) {
      return run.method != examined_.method && run.outcome == to_string(Outcome::Success);
    });
    if (tested == runs.end() || reference == runs.end()) return "";
    const Trajectory failing = file_.read_trajectory(*tested);
    const Trajectory successful = file_.read_trajectory(*reference);
    if (failing.samples.empty() || successful.samples.empty()) return "";
    const World world(file_.read_scenario(failure.smallest), options_.simulation.resolution);
    return tested->scenario_name + ": " +
           departure_text(tested->method, reference->method,
                          find_departure(world, movers_of(world, failing), options_.robot, failing,
                                         successful));
  }

  /// All that moved in a run but the robot.
  Movers movers_of(const World& world, const Trajectory& run) const {
    if (world.scenario().people().empty()) return world.scenario().movers();
    return movers_along(world, options_.robot, options_.simulation, run, options_.people);
  }

  FailureFacts facts_of(const ExaminedFailure& failure) const {
    const auto run = file_.read_run(failure.smallest, examined_.method, examined_.repetition);
    if (!run) throw job_error(file_.path(), "no run in scenario " + failure.smallest);
    const World world(file_.read_scenario(failure.smallest), options_.simulation.resolution);
    Trajectory trajectory = file_.read_trajectory(*run);
    if (trajectory.samples.empty()) {  // the method ended its process before the first cycle
      trajectory.samples.emplace_back();
      trajectory.samples.back().pose = world.scenario().start();
    }
    const auto outcome = from_name<Outcome>(run->outcome);
    if (!outcome) throw file_error(file_.path(), "unknown outcome " + run->outcome);
    FailureFacts facts =
        measure_end(world, movers_of(world, trajectory), options_.robot, *outcome, trajectory);
    facts.obstacles = failure.obstacles;
    facts.bottleneck_width = failure.bottleneck_width;
    return facts;
  }

  ReportedCluster explained(const FailureCluster& cluster) const {
    ReportedCluster report;
    report.name = cluster.name;
    std::vector<const ReportedFailure*> pairs;
    for (const std::size_t member : cluster.members) {
      report.members.push_back(reported_[member]);
      if (failures_[member].independent && !reported_[member].neighbors.empty())
        pairs.push_back(&reported_[member]);
    }
    report.scenarios = contrasts(runs_.descriptors, pairs, true);
    report.runs = contrasts(runs_.metrics, pairs, false);
    for (const Contrast& contrast : report.scenarios)
      if (contrast.holds)
        report.statements.push_back(contrast_sentence(contrast, "successful neighbors"));
    report.basis = basis_of(report, pairs.size());
    if (pairs.size() == 1) {  // quartiles and tests of one failure mean nothing
      report.scenarios.clear();
      report.runs.clear();
    }
    return report;
  }

  std::vector<Contrast> contrasts(const std::vector<ValueColumn>& columns,
                                  const std::vector<const ReportedFailure*>& pairs,
                                  bool of_scenarios) const {
    std::vector<MatchedValues> family;
    for (const ValueColumn& column : columns) {
      if (!of_scenarios && follows_from_outcome(column)) continue;
      MatchedValues values{column.info(), {}, {}};
      for (const ReportedFailure* pair : pairs) {
        const auto failing = value_of(column, pair->compared, of_scenarios);
        const auto successful = median_of(column, pair->neighbors, of_scenarios);
        if (!failing || !successful) continue;
        values.group.push_back(*failing);
        values.reference.push_back(*successful);
      }
      family.push_back(std::move(values));
    }
    return contrast_matched(family, confidence_);
  }

  std::optional<double> value_of(const ValueColumn& column, std::size_t run,
                                 bool of_scenario) const {
    const std::size_t row = of_scenario ? runs_.scenario[run] : run;
    if (column.is_na(row)) return std::nullopt;
    return column.number(row);
  }

  std::optional<double> median_of(const ValueColumn& column, const std::vector<std::size_t>& runs,
                                  bool of_scenarios) const {
    std::vector<double> values;
    for (const std::size_t run : runs)
      if (const auto value = value_of(column, run, of_scenarios)) values.push_back(*value);
    if (values.empty()) return std::nullopt;
    return median(values);
  }

  std::string basis_of(const ReportedCluster& cluster, std::size_t pairs) const {
    if (pairs == 0) return "No failure has successful neighbors to compare with.";
    const std::size_t needed = min_pairs_to_hold(cluster.scenarios.size(), confidence_);
    if (pairs == 1)
      return "One failure has successful neighbors; contrasts need at least " +
             std::to_string(needed) + ".";
    std::string text = std::to_string(pairs) + " of " +
                       count_text(cluster.members.size(), "failure") +
                       " compared with their successful neighbors in " +
                       count_text(cluster.scenarios.size(), "descriptor");
    if (pairs < needed)
      return text + ", too few: significance needs at least " + std::to_string(needed) + ".";
    return text + (cluster.statements.empty() ? ": no difference holds." : ".");
  }
};

}  // namespace

std::vector<ReportedCluster> explain_failures(const ResultFile& file, const ResultTable& runs,
                                              const ReportOptions& options,
                                              const ExaminedFailures& examined) {
  return Explainer(file, runs, options, examined).clusters();
}

}  // namespace slalom
