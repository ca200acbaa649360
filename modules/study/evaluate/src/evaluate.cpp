// SPDX-License-Identifier: BSD-3-Clause
#include "callback_progress.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/table_text.h>
#include <slalom/campaign/run_campaign.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/result_file.h>
#include <slalom/results/privileged.h>
#include <slalom/results/table_builder.h>

#include <optional>
#include <set>

namespace slalom {
namespace {

/// Collects the records of a campaign in a table, and in a result file if one is wanted.
class TableSink : public CampaignSink {
 public:
  TableSink(const CampaignOptions& campaign, const Options& options)
      : builder_(campaign.descriptor_infos(), campaign.metric_infos()), options_(options) {
    if (!options.output.empty())
      file_ = ResultFile::create(options.output, {}, campaign.descriptor_infos(),
                                 campaign.metric_infos());
  }

  void add_scenario(const ScenarioRecord& record, const References& references,
                    const PackedScenario& packed) override {
    builder_.add_scenario(record);
    if (file_) file_->add_scenario(record, packed, references.timing);
  }
  void add_run(const RunRecord& run, const RunTiming& timing,
               const PackedTrajectory& trajectory) override {
    builder_.add_run(run, timing);
    if (file_) file_->add_run(run, timing, trajectory);
    if (options_.observer) options_.observer(run, trajectory.unpack(run_id(run)));
  }
  ResultTable finish(const Manifest& manifest) {
    if (file_) {
      file_->replace_manifest(manifest);
      file_->commit();
    }
    ResultTable table = builder_.finish();
    table.manifest = manifest;
    return table;
  }

 private:
  TableBuilder builder_;
  std::optional<ResultFile> file_;
  const Options& options_;
};

CampaignOptions campaign_options(const Options& options, const std::vector<Scenario>& scenarios) {
  CampaignOptions campaign = options;
  campaign.record.trajectories = options.observer || !options.output.empty()
                                     ? StoredTrajectories::All
                                     : StoredTrajectories::None;
  campaign.record.repeated_runs = 0;  // not measured here
  campaign = checked_options(std::move(campaign), "options ");
  campaign.adapt_to(scenarios);
  return campaign;
}

/// The settings by SECTION.KEY, and the versions.
Manifest make_manifest(const Campaign& campaign) {
  Manifest manifest = {{"campaign", campaign.options.name},
                       {"seed", std::to_string(campaign.options.seed)},
                       {"version.slalom", version()},
                       {"version.mrpt", mrpt_version()},
                       {"version.compiler", compiler_version()}};
  write_settings(campaign.options,
                 [&](const std::string& section, const std::string& key, const std::string& text) {
                   manifest[section + "." + key] = text;
                 });
  std::vector<std::string> methods;
  for (const NamedMethod& method : campaign.methods) methods.push_back(method.name);
  manifest["campaign.methods"] = join(methods, ", ");
  return manifest;
}

/// The methods, which are added to `privileged` when they are made and are so.
std::vector<NamedMethod> recording_privileges(std::vector<NamedMethod> methods,
                                              PrivilegedMethods& privileged) {
  for (NamedMethod& method : methods)
    method.make = [make = method.make, name = method.name, &privileged](const RobotModel& robot,
                                                                        const SensorModel& sensor) {
      auto made = make(robot, sensor);
      privileged.add(name, made->uses_tracks(), made->uses_map());
      return made;
    };
  return methods;
}

std::vector<Scenario> without_duplicates(const std::vector<Scenario>& scenarios) {
  std::set<std::string> hashes;
  std::vector<Scenario> distinct;
  for (const Scenario& scenario : scenarios)
    if (hashes.insert(scenario.hash()).second) distinct.push_back(scenario);
  return distinct;
}

}  // namespace

ResultTable evaluate(const Methods& methods, const std::vector<Scenario>& scenarios,
                     const Options& options) {
  if (methods.list().empty()) throw usage_error("methods", "none given", "at least one");
  if (scenarios.empty()) throw usage_error("evaluate", "no scenario given", "generate()");
  PrivilegedMethods privileged;
  const Campaign campaign{
      campaign_options(options, scenarios), without_duplicates(scenarios),
      options.in_process ? recording_privileges(methods.list(), privileged) : methods.list(),
      options.planner.get()};
  if (!options.in_process) privileged = check_methods(campaign);
  TableSink sink(campaign.options, options);
  CallbackProgress progress(options);
  run_campaign(campaign, sink,
               {worker_count(options.workers), progress, options.cancel, options.in_process});
  Manifest manifest = make_manifest(campaign);
  store_privileged(privileged, manifest);
  return sink.finish(manifest);
}

std::string cross_table(const ResultTable& table, const std::string& rows,
                        const std::vector<std::string>& columns, double confidence) {
  AnalysisOptions analysis;
  analysis.confidence = confidence;
  ResultTable shown = table;
  mark_privileged(shown);
  std::string text;
  for (const CrossTable& one : build_cross_tables(shown, parse_bin_specs(rows), columns, analysis))
    text += (text.empty() ? "" : "\n") + render_cross_table_text(one);
  const std::string footnote = privileged_footnote(shown);
  return footnote.empty() ? text : text + "\n" + footnote + "\n";
}

}  // namespace slalom
