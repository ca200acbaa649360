#include "recorded_campaign.h"
#include "verbs.h"

#include <slalom/campaign/measure.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/ompl/ompl_planner.h>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

struct MetricsArguments {
  std::string log, results;
  bool json = false;
};

/// The record of the run, everything but its identity made anew from what was recorded.
RunRecord measure_again(const RecordedRun& run, const std::string& path, const IniFile& ini) {
  CampaignOptions options = read_campaign_options(ini);
  const auto ompl_options = read_options<OmplOptions>(ini, "reference");
  options.reference_gap = ompl_options.gap;
  const auto planner = make_ompl_planner(ompl_options, options.setup.robot);
  const World world(scenario_of(run, path), options.setup.simulation.resolution);
  RunRecord record = record_of(run);
  record.trajectory_hash = run.trajectory.hash();
  record.metrics = measure_run(options, world, find_references(options, planner.get(), world),
                               run.trajectory, run.outcome);
  return record;
}

std::string text_of(const Value& value) {
  return value.is_na() ? "NA (" + value.reason() + ")" : format_number(value.number());
}

void print(const RunRecord& record) {
  std::cout << "outcome = " << record.outcome << "\n";
  for (const auto& [id, versioned] : record.metrics) {
    const std::string unit = metric(id).info().unit;
    std::cout << id << " = " << text_of(versioned.value)
              << (unit == "-" || versioned.value.is_na() ? "" : " " + unit) << "\n";
  }
}

const RunRecord& stored_run(const ResultTable& table, const RunRecord& run,
                            const std::string& path) {
  const auto found =
      std::find_if(table.runs.begin(), table.runs.end(), [&](const RunRecord& other) {
        return other.scenario_hash == run.scenario_hash && other.method == run.method &&
               other.repetition == run.repetition;
      });
  if (found == table.runs.end())
    throw job_error(path, "has no run " + run_id(run), "the results of this run");
  return *found;
}

/// Throws Error (Job) at the first value that is not the stored one.
void compare(const RunRecord& run, const MetricsArguments& arguments) {
  const ResultTable table = ResultFile::open(arguments.results).read_table();
  const RunRecord& stored = stored_run(table, run, arguments.results);
  const auto expect = [&](const std::string& what, const std::string& now,
                          const std::string& then) {
    if (now != then) throw job_error(arguments.log, what + " is " + now, then + " as stored");
  };
  expect("outcome", run.outcome, stored.outcome);
  expect("trajectory hash", run.trajectory_hash, stored.trajectory_hash);
  for (const auto& [id, value] : stored.metrics) {
    const auto found = run.metrics.find(id);
    if (found == run.metrics.end()) throw job_error(arguments.log, id + " is not computed");
    expect(id, text_of(found->second.value), text_of(value.value));
    expect("version of " + id, std::to_string(found->second.version),
           std::to_string(value.version));
  }
}

void measure(const MetricsArguments& arguments) {
  const RecordedRun run = read_run(arguments.log);
  const IniFile ini = campaign_of(run, arguments.log, "", {});
  const RunRecord record = measure_again(run, arguments.log, ini);
  if (arguments.json) {
    ResultTable table;
    table.manifest["campaign"] = read_campaign_options(ini).name;
    std::cout << dump_line(table, record) << "\n";
  } else {
    print(record);
  }
  if (!arguments.results.empty()) compare(record, arguments);
}

}  // namespace

void define_metrics(CLI::App& app) {
  static MetricsArguments arguments;
  CLI::App* verb =
      app.add_subcommand("metrics", "Compute the metrics of a recorded run from its rawlog alone");
  verb->add_option("log", arguments.log, "The run (.rawlog)")->required();
  verb->add_option("--results", arguments.results,
                   "A result file (.results) that has the run: fail when a stored value differs");
  verb->add_flag("--json", arguments.json, "One line of JSON, as slalom-analyze dump prints it");
  verb->callback([] { measure(arguments); });
}

}  // namespace slalom
