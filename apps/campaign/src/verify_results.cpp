// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.h"
#include "repeated_runs.h"
#include "verify_plan.h"

#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/app/verify_results.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/find_run.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/methods/registry.h>
#include <slalom/metrics/mover_metrics.h>
#include <slalom/references/reference_codec.h>
#include <slalom/results/recorded_ini.h>
#include <slalom/results/repeatability.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

/// A run that is not the one in the file.
struct DifferingRun {
  ExecutedRun run;
  std::string difference;
};

/// Compares the results of a campaign with those in a file.
class ComparingSink : public CampaignSink {
 public:
  /// `first_repetition`: earlier ones are not compared.
  ComparingSink(const ResultFile& file, int first_repetition)
      : file_(file),
        campaign_(file.read_manifest()["campaign"]),
        first_repetition_(first_repetition) {}

  void add_scenario(const ScenarioRecord& record, const References& references,
                    const PackedScenario&) override {
    record_[record.hash] = record;
    ++report.scenarios;
    const References recorded = file_.read_references(record.hash);
    References now = references;
    if (recorded.shortest && recorded.shortest->path.empty()) remove_paths(now);  // in a bundle
    if (to_bytes(now) != to_bytes(recorded))
      report.differences.push_back("scenario " + record.name +
                                   ": its reference paths are different");
  }

  void add_run(const RunRecord& run, const RunTiming&,
               const PackedTrajectory& trajectory) override {
    if (run.repetition < first_repetition_) return;
    const auto recorded = file_.read_run(run.scenario_hash, run.method, run.repetition);
    if (!recorded) return;  // of an incomplete campaign
    ++report.runs;
    const std::string before =
        dump_line(campaign_, file_.read_record(run.scenario_hash), *recorded);
    const std::string now = dump_line(campaign_, record_[run.scenario_hash], run);
    if (before == now) return;
    for (const RunRecord* record : {&*recorded, &run}) {
      if (record->outcome != to_string(Outcome::MethodDeadline)) continue;
      report.time_limits.push_back("run " + run_id(run) +
                                   ": ended at a time limit on one of the machines (" +
                                   record->outcome_detail + ")");
      return;
    }
    differing.push_back({{run, trajectory}, line_difference(before, now)});
  }

  VerifyReport report;
  std::vector<DifferingRun> differing;

 private:
  const ResultFile& file_;
  std::string campaign_;
  int first_repetition_;
  std::map<std::string, ScenarioRecord> record_;
};

std::vector<Scenario> sample_scenarios(const ResultFile& file, const VerifySample& sample) {
  std::vector<std::string> hashes = read_results(file.path(), {{"success"}}).scenario_hashes;
  const auto order = [&](const std::string& hash) {
    return Hasher().add(sample.seed).add(hash).hex();
  };
  std::sort(hashes.begin(), hashes.end(),
            [&](const std::string& a, const std::string& b) { return order(a) < order(b); });
  const double wanted = std::ceil(sample.fraction * static_cast<double>(hashes.size()));
  hashes.resize(std::min(hashes.size(), static_cast<std::size_t>(std::max(1.0, wanted))));
  std::vector<Scenario> scenarios;
  for (const std::string& hash : hashes) scenarios.push_back(file.read_scenario(hash));
  return scenarios;
}

/// The campaign of one run: its scenario is returned; other methods and later repetitions are left
/// out.
std::vector<Scenario> restrict_to_run(const ResultFile& file, const RunRecord& run,
                                      CampaignConfig& config) {
  auto& methods = config.methods;
  methods.erase(
      std::remove_if(methods.begin(), methods.end(),
                     [&](const NamedMethod& method) { return method.name != run.method; }),
      methods.end());
  if (methods.empty())
    throw usage_error("method '" + run.method + "'", "is not in the campaign",
                      "the campaign's .ini");
  config.options.repetitions = run.repetition + 1;
  return {file.read_scenario(run.scenario_hash)};
}

std::vector<std::string> environment_differences(const Manifest& recorded, const Manifest& here,
                                                 const std::string& path) {
  std::vector<std::string> differences;
  for (const auto& [key, text] : here) {
    const bool is_environment = starts_with(key, "version.") || starts_with(key, "environment.") ||
                                starts_with(key, "method.");
    const auto found = recorded.find(key);
    if (!is_environment || found == recorded.end() || found->second == text) continue;
    differences.push_back(is_method_file(key) ? to_string({key, text, found->second}, path)
                                              : key + " was " + found->second + " and is " + text);
  }
  return differences;
}

/// Adds the quantities about movers, people and headings that were computed: a sample may contain
/// none.
void add_measured(Manifest& manifest, const std::string& path, CampaignOptions& options) {
  const CampaignOptions measured =
      read_measuring_options(IniFile::from_text(manifest[kEffectiveKey], path));
  if (contains(measured.metrics, mover_metric_ids()[0]) ||
      contains(measured.descriptors, mover_descriptor_ids()[0]))
    options.add_mover_quantities();
  if (contains(measured.metrics, people_metric_ids()[0])) options.add_people_metrics();
  if (contains(measured.metrics, goal_heading_metric_ids()[0])) options.add_goal_heading_metrics();
}

/// Says of each differing run whether the method or the file is the reason. Each method executes
/// one of them once more: the last, so that other runs of its process are before it. The file is
/// not asked, since it would then excuse itself.
bool explain_differences(const std::vector<DifferingRun>& runs, const Manifest& manifest,
                         const Campaign& campaign, const Execution& execution,
                         VerifyReport& report) {
  std::map<std::string, const ExecutedRun*> last;
  for (const DifferingRun& one : runs) last[one.run.record.method] = &one.run;
  std::set<RunKey> chosen;
  for (const auto& [method, run] : last) chosen.insert(key_of(run->record));
  RepeatedRuns again{true, {}};
  if (!chosen.empty()) again = execute_again(campaign, chosen, nullptr, execution);
  std::map<std::string, std::string> found;  // by method, "" for equal executions
  for (const auto& [key, run] : again.runs) {
    const ExecutedRun& before = *last.at(run.record.method);
    const Trajectory trajectory = before.trajectory.unpack("");
    found[run.record.method] = execution_difference(before.record, &trajectory, run);
  }
  std::map<std::string, Repeatability> measured = repeatability_of(manifest);
  for (const DifferingRun& one : runs) {
    const std::string &method = one.run.record.method, id = "run " + run_id(one.run.record) + ": ";
    const auto executed = found.find(method);
    if (executed != found.end() && !executed->second.empty())
      report.not_repeatable.push_back(id + "not repeatable: " + method +
                                      ", executed once more here, " + executed->second);
    else
      report.differences.push_back(
          id + one.difference +
          (executed == found.end() ? ""
                                   : "; " + method + ", executed once more here, repeats itself") +
          (measured[method].is_repeatable() ? "" : ", though the file says that it does not"));
  }
  return again.complete;
}

/// Compares what does not need an execution: the plan, what the manifest states, the scenarios.
void compare_whole(const ResultFile& file, const CampaignConfig& config,
                   const CampaignArguments& arguments, const VerifySample& sample,
                   VerifyReport& report) {
  const PlanComparison plan = compare_plan(file, config);
  report.total_runs = plan.present;
  if (!plan.shard.empty()) return;
  if (!plan.complete()) report.differences.push_back("the file " + plan.text());
  for (const std::string& line : statement_differences(file, config))
    report.differences.push_back(line);
  if (!sample.scenarios) return;
  const auto progress = make_interruptible_progress(arguments.quiet);
  ScenarioSet set = compare_scenarios(file, config, worker_count(arguments.jobs), *progress);
  report.scenario_set = std::move(set.text);
  std::move(set.differences.begin(), set.differences.end(), std::back_inserter(report.differences));
}

}  // namespace

VerifyReport verify_results(const std::string& path, const CampaignArguments& arguments,
                            const VerifySample& sample, const EnvironmentHandler& on_environment) {
  const ResultFile file = ResultFile::open(path);
  Manifest manifest = file.read_manifest();
  const IniFile ini =
      arguments.config.empty() ? recorded_ini(manifest, path) : load_campaign_ini(arguments);
  CampaignConfig config = read_campaign(ini);
  add_measured(manifest, path, config.options);
  config.effective_ini = effective_ini(ini, config);
  const auto planner = make_ompl_planner(config.reference, config.options.robot);
  const std::optional<RunRecord> only =
      sample.run.empty() ? std::nullopt : std::optional(find_run(file, sample.run));
  const std::vector<Scenario> scenarios =
      only ? restrict_to_run(file, *only, config) : sample_scenarios(file, sample);
  if (arguments.config.empty() && !sample.trust)
    require_no_foreign_code(ini, method_sections(ini, config.methods), path);
  check_campaign(config);
  std::vector<std::string> environment =
      environment_differences(manifest, make_manifest(config, {}, std::nullopt), path);
  on_environment(environment);
  const Campaign campaign{config.options, scenarios, config.methods, planner.get()};
  const auto progress = make_terminal_progress(arguments.quiet);
  const InterruptGuard guard;
  ComparingSink sink(file, only ? only->repetition : 0);
  const Execution execution{campaign_workers(config, arguments), *progress, InterruptGuard::raised};
  sink.report.environment = std::move(environment);
  if (!only) compare_whole(file, config, arguments, sample, sink.report);
  const CampaignSummary summary = run_campaign(campaign, sink, execution);
  sink.report.complete = summary.complete && explain_differences(sink.differing, manifest, campaign,
                                                                 execution, sink.report);
  return sink.report;
}

std::string verdict(const VerifyReport& report, const std::string& path) {
  if (!report.complete) throw Interrupted("nothing was changed");
  const std::size_t unequal = report.not_repeatable.size(), runs = report.identical_runs();
  if (runs == 0 && unequal == 0 && report.runs > 0)
    throw job_error(path,
                    "a time limit ended each of the runs on one of the machines, so that none was "
                    "compared",
                    "a machine that is fast enough, or longer [limits]");
  const std::string what =
      count_text(runs, "run") + " in " + count_text(report.scenarios, "scenario");
  if (!report.differences.empty())
    throw job_error(path, count_text(report.differences.size(), "difference") + " in " + what,
                    "identical results");
  return what + (runs == 1 ? " is identical" : " are identical") +
         (unequal == 0 ? ""
                       : "; " + count_text(unequal, "run") + " of methods that are not repeatable");
}

}  // namespace slalom
