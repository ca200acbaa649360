// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/recorded_campaign.h>
#include <slalom/campaign/measure.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/simulation/evaluate_trajectory.h>

#include <iostream>
#include <optional>

namespace slalom {
namespace {

struct MetricsArguments {
  std::string log, results;
  bool json = false;
};

/// The record of the run with metrics computed from the recorded trajectory.
RunRecord recompute_metrics(const RecordedRun& run, const std::string& path,
                            const CampaignOptions& options, const OmplOptions& reference) {
  const auto planner = make_ompl_planner(reference, options.robot);
  const World world(scenario_of(run, path), options.simulation.resolution);
  RunRecord record = record_of(run);
  record.trajectory_hash = run.trajectory.hash();
  Hindrances hindrances;
  const Movers movers = movers_along(world, options.robot, options.simulation, run.trajectory,
                                     options.people, &hindrances);
  record.metrics = measure_run(options, world, find_references(options, planner.get(), world),
                               run.trajectory, run.outcome, movers, hindrances);
  return record;
}

void print(const RunRecord& record) {
  std::cout << "outcome = " << record.outcome << "\n";
  for (const auto& [id, versioned] : record.metrics)
    std::cout << id << " = " << format_value(versioned.value, metric(id).info.unit) << "\n";
}

RunRecord stored_run(const RunRecord& run, const std::string& path) {
  const ResultFile file = ResultFile::open(path);
  const auto stored = file.read_run(run.scenario_hash, run.method, run.repetition);
  if (!stored) throw job_error(path, "contains no run " + run_id(run), "the results of this run");
  return *stored;
}

/// Adds metrics that are stored because of another scenario: it may have movers or people.
void add_stored(const RunRecord& stored, CampaignOptions& options) {
  const std::vector<std::string> known = metric_ids();
  for (const auto& [id, value] : stored.metrics)
    if (contains(known, id) && !contains(options.metrics, id)) options.metrics.push_back(id);
}

/// Throws Error (Job) at the first value that differs from the stored one.
void compare(const RunRecord& run, const RunRecord& stored, const MetricsArguments& arguments) {
  const auto expect = [&](const std::string& name, const std::string& value,
                          const std::string& expected) {
    if (value != expected)
      throw job_error(arguments.log, name + " is " + value, "the stored value " + expected);
  };
  expect("outcome", run.outcome, stored.outcome);
  expect("trajectory hash", run.trajectory_hash, stored.trajectory_hash);
  for (const auto& [id, value] : stored.metrics) {
    const auto found = run.metrics.find(id);
    if (found == run.metrics.end()) throw job_error(arguments.log, id + " is not computed");
    expect(id, format_value(found->second.value), format_value(value.value));
    expect("version of " + id, std::to_string(found->second.version),
           std::to_string(value.version));
  }
}

void measure(const MetricsArguments& arguments) {
  const RecordedRun run = read_run(arguments.log);
  const IniFile ini = campaign_of(run, arguments.log, "", {});
  CampaignOptions options = read_campaign_options(ini);
  const auto reference = read_options<OmplOptions>(ini, "reference");
  options.reference_gap = reference.gap;
  options.adapt_to({scenario_of(run, arguments.log)});
  std::optional<RunRecord> stored;
  if (!arguments.results.empty()) {
    stored = stored_run(record_of(run), arguments.results);
    add_stored(*stored, options);
  }
  const RunRecord record = recompute_metrics(run, arguments.log, options, reference);
  if (arguments.json) {
    std::cout << dump_line(options.name, {}, record) << "\n";
  } else {
    print(record);
  }
  if (stored) compare(record, *stored, arguments);
}

}  // namespace

void define_metrics(CLI::App& app) {
  static MetricsArguments arguments;
  CLI::App* verb =
      app.add_subcommand("metrics", "Compute the metrics of a recorded run from its rawlog");
  verb->add_option("log", arguments.log, "The run (.rawlog)")->required();
  verb->add_option("--results", arguments.results,
                   "Result file (.results) with the run; fails if a stored value differs");
  verb->add_flag("--json", arguments.json, "Print one line of JSON, as slalom-analyze dump");
  verb->callback([] { measure(arguments); });
}

}  // namespace slalom
