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
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/find_run.h>
#include <slalom/io/imported_table.h>
#include <slalom/io/own_columns.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/methods/registry.h>
#include <slalom/metrics/metric.h>
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

/// The columns of a file that functions of its author have computed.
std::vector<std::string> own_columns_of(const Manifest& manifest) {
  const std::string prefix = kOwnColumnPrefix;
  std::vector<std::string> ids;
  for (const auto& [key, source] : manifest)
    if (const std::string id = key.substr(std::min(key.size(), prefix.size()));
        starts_with(key, prefix) && !contains(metric_ids(), id) && !contains(descriptor_ids(), id))
      ids.push_back(id);
  return ids;
}

/// Compares the results of a campaign with those in a file, without such columns.
class ComparingSink : public CampaignSink {
 public:
  /// `first_repetition`: earlier ones are not compared.
  ComparingSink(const ResultFile& file, const CampaignOptions& options, int first_repetition)
      : file_(file),
        campaign_(file.read_manifest()["campaign"]),
        own_columns_(own_columns_of(file.read_manifest())),
        options_(options),
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

  void add_run(const RunRecord& run, const RunTiming& timing,
               const PackedTrajectory& trajectory) override {
    if (run.repetition < first_repetition_) return;
    auto recorded = file_.read_run(run.scenario_hash, run.method, run.repetition);
    if (!recorded) return;  // of an incomplete campaign
    ScenarioRecord recorded_scenario = file_.read_record(run.scenario_hash);
    for (const std::string& id : own_columns_) {
      recorded->metrics.erase(id);
      recorded_scenario.descriptors.erase(id);
    }
    ++report.runs;
    VerifiedRuns& of_method = report.methods[run.method];
    ++of_method.runs;
    const std::string before = dump_line(campaign_, recorded_scenario, *recorded);
    const std::string now = dump_line(campaign_, record_[run.scenario_hash], run);
    if (before == now)
      ++of_method.identical;
    else if (run.outcome == kDeadline)
      report.time_limits.push_back("run " + run_id(run) + ": ended at a time limit here (" +
                                   run.outcome_detail + ")");
    else if (recorded->outcome == kDeadline)
      compare_limited(run, *recorded, timing);
    else
      differing.push_back({{run, trajectory}, line_difference(before, now)});
  }

  VerifyReport report;
  std::vector<DifferingRun> differing;

 private:
  inline static const std::string kDeadline{to_string(Outcome::MethodDeadline)};

  /// A run that a limit of time ended in the file, and not here.
  void compare_limited(const RunRecord& run, const RunRecord& recorded, const RunTiming& timing) {
    const std::string told = "run " + run_id(run) + ": ended at a time limit in the file (" +
                             recorded.outcome_detail + ")";
    if (may_reach_limit(timing))
      report.time_limits.push_back(told);
    else
      report.differences.push_back(told + "; here with " + run.outcome + " after " +
                                   format_fixed(timing.wall_seconds, 3) +
                                   " s, too early for a slower machine");
  }

  /// Whether a machine that is kSlowdown times slower may reach a limit of time in this run.
  bool may_reach_limit(const RunTiming& timing) const {
    const auto cycle = timing.values.find("cycle_time_max");
    const double seconds = timing.wall_seconds * kSlowdown;
    const double cycle_seconds =
        cycle == timing.values.end() ? 0 : cycle->second / 1000 * kSlowdown;
    const LimitsSection& limits = options_.limits;
    return (limits.run_wall_time > 0 && seconds >= limits.run_wall_time) ||
           (limits.run_cpu_time > 0 && seconds >= limits.run_cpu_time) ||
           (options_.deadline.cycle_deadline > 0 &&
            cycle_seconds >= options_.deadline.cycle_deadline);
  }

  static constexpr double kSlowdown = 10;
  const ResultFile& file_;
  std::string campaign_;
  std::vector<std::string> own_columns_;
  const CampaignOptions& options_;
  int first_repetition_;
  std::map<std::string, ScenarioRecord> record_;
};

std::vector<Scenario> sample_scenarios(const ResultFile& file, const VerifySample& sample) {
  std::vector<std::string> hashes;
  for (const auto& [hash, name] : file.read_scenario_names()) hashes.push_back(hash);
  const auto order = [&](const std::string& hash) {
    return Hasher().add(sample.seed.value_or(0)).add(hash).hex();
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

/// Checksums of all runs and scenarios, and hashes of trajectories: a sample would miss most of
/// them.
void require_intact(const ResultFile& file) {
  std::vector<std::string> damaged = read_results(file.path()).damaged;
  // Figures of the wall clock are not compared.
  damaged.erase(std::remove_if(damaged.begin(), damaged.end(),
                               [](const std::string& what) { return starts_with(what, "wall-"); }),
                damaged.end());
  if (!damaged.empty())
    throw file_error(file.path(),
                     damaged.front() + " is damaged (does not match its checksum), " +
                         std::to_string(damaged.size()) + " in all",
                     "an unmodified file");
  file.for_each_run([&](const RunRecord& run) { file.read_trajectory(run); });
}

/// Statements of a file about a quantity beside its values, by which tables judge them.
std::string statement_of(const QuantityInfo& info) {
  return info.name + ", " + info.unit + ", " + std::string(to_string(info.direction)) + ", " +
         std::string(to_string(info.kind)) + ", " + range_notation(info.range);
}

/// Adds the quantities of the file that are not as this version has them. Values of other versions
/// differ themselves.
void compare_quantities(const std::vector<QuantityInfo>& stated,
                        const std::vector<QuantityInfo>& here, VerifyReport& report) {
  for (const QuantityInfo& info : stated)
    for (const QuantityInfo& known : here)
      if (known.id == info.id && known.version == info.version &&
          statement_of(known) != statement_of(info))
        report.differences.push_back(printable_line("the file states " + info.id + " as " +
                                                    statement_of(info) + "; it is " +
                                                    statement_of(known)));
}

/// Compares what does not need an execution: the plan, what the manifest states, the scenarios.
void compare_whole(const ResultFile& file, const CampaignConfig& config, const IniFile& ini,
                   const Campaign& campaign, const Execution& execution, const VerifySample& sample,
                   VerifyReport& report) {
  const PlanComparison plan = compare_plan(file, config);
  report.total_runs = plan.present;
  report.total_scenarios = file.read_scenario_names().size();
  if (!plan.is_whole())  // with names that only a forged file has
    report.differences.push_back(printable_line("the file " + plan.text()));
  compare_quantities(file.metrics(), config.options.metric_infos(), report);
  compare_quantities(file.descriptors(), config.options.descriptor_infos(), report);
  for (const std::string& line : statement_differences(file, config, ini))
    report.differences.push_back(line);
  if (!sample.scenarios) return;
  ScenarioSet set = compare_scenarios(file, config, execution.workers, execution.progress);
  report.scenario_set = std::move(set.text);
  std::move(set.differences.begin(), set.differences.end(), std::back_inserter(report.differences));
  const Manifest manifest = file.read_manifest();
  if (manifest.count("until") == 0) return;
  if (set.made.empty()) {
    report.unchecked.push_back("until: the number of scenarios cannot be verified without " +
                               std::string("the list or the maps of the campaign"));
  } else if (const std::string stop = compare_stop(file, campaign, set.made, execution);
             !stop.empty()) {
    report.differences.push_back(stop);
  }
}

}  // namespace

VerifyReport verify_results(const std::string& path, const CampaignArguments& arguments,
                            const VerifySample& sample, const EnvironmentHandler& on_environment) {
  const ResultFile file = ResultFile::open(path);
  Manifest manifest = file.read_manifest();
  expect_scenarios(manifest, path);
  require_intact(file);
  const IniFile ini =
      arguments.config.empty() ? recorded_ini(manifest, path) : load_campaign_ini(arguments);
  CampaignConfig config = read_campaign(ini);
  if (arguments.config.empty() && !sample.trust)
    require_no_foreign_code(ini, method_sections(ini, config.methods), path);
  add_measured(manifest, path, config.options);
  config.effective_ini = effective_ini(ini, config);
  const auto planner = make_ompl_planner(config.reference, config.options.robot);
  const std::optional<RunRecord> only =
      sample.run.empty() ? std::nullopt : std::optional(find_run(file, sample.run));
  const std::vector<Scenario> scenarios =
      only ? restrict_to_run(file, *only, config) : sample_scenarios(file, sample);
  check_campaign(config);
  std::vector<std::string> environment =
      environment_differences(manifest, make_manifest(config, {}, std::nullopt), path);
  on_environment(environment);
  const Campaign campaign{config.options, scenarios, config.methods, planner.get()};
  const auto progress = make_terminal_progress(arguments.quiet);
  const InterruptGuard guard;
  ComparingSink sink(file, config.options, only ? only->repetition : 0);
  const Execution execution{campaign_workers(config, arguments), *progress, InterruptGuard::raised};
  sink.report.environment = std::move(environment);
  for (const std::string& id : own_columns_of(manifest))
    sink.report.unchecked.push_back(printable_line(
        id + ": not verified, since the function that computes it is not executed (" +
        kOwnColumnPrefix + id + " of the manifest)"));
  if (!only) compare_whole(file, config, ini, campaign, execution, sample, sink.report);
  const CampaignSummary summary = run_campaign(campaign, sink, execution);
  sink.report.complete = summary.complete && explain_differences(sink.differing, manifest, campaign,
                                                                 execution, sink.report);
  return sink.report;
}

std::size_t VerifyReport::identical_runs() const {
  std::size_t count = 0;
  for (const auto& [method, verified] : methods) count += verified.identical;
  return count;
}

std::size_t detectable_changes(std::size_t sampled, std::size_t all) {
  // Probability to see none, drawn without replacement: C(all - changed, sampled) / C(all,
  // sampled).
  double unseen = 1;
  std::size_t changed = 0;
  while (unseen > 0.05 * (1 + 1e-9) && changed < all) {
    unseen *= std::max(0.0, 1 - static_cast<double>(sampled) / static_cast<double>(all - changed));
    ++changed;
  }
  return changed;
}

std::string verdict(const VerifyReport& report, const std::string& path) {
  if (!report.complete) throw Interrupted("nothing was changed");
  const std::size_t runs = report.identical_runs();
  const std::size_t unverifiable = report.time_limits.size() + report.not_repeatable.size();
  if (!report.differences.empty())
    throw job_error(path,
                    count_text(report.differences.size(), "difference") + " in " +
                        count_text(report.runs, "run") + " in " +
                        count_text(report.scenarios, "scenario"),
                    "identical results");
  if (runs == 0 && report.time_limits.size() == report.runs && report.runs > 0)
    throw job_error(path,
                    "a time limit ended each of the runs on one of the machines, so that none was "
                    "compared",
                    "a machine that is fast enough, or longer [limits]");
  const std::string what = report.total_runs == 0
                               ? count_text(runs, "run")
                               : std::to_string(runs) + " of " +
                                     count_text(report.total_runs, "run") + " in " +
                                     std::to_string(report.scenarios) + " of " +
                                     count_text(report.total_scenarios, "scenario");
  return what + (runs == 1 ? " is identical" : " are identical") +
         (unverifiable == 0 ? "" : "; " + count_text(unverifiable, "run") + " cannot be verified");
}

}  // namespace slalom
