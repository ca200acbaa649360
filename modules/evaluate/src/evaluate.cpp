#include "callback_progress.h"

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/table_text.h>
#include <slalom/campaign/campaign.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/results/table_builder.h>

#include <set>

namespace slalom {
namespace {

/// Collects the records of a campaign in a table.
class TableSink : public CampaignSink {
 public:
  explicit TableSink(const CampaignOptions& options)
      : builder_(options.descriptor_infos(), options.metric_infos()) {}

  void add_scenario(const ScenarioRecord& record, const Scenario&, const References&) override {
    builder_.add_scenario(record);
  }
  void add_run(const RunRecord& run, const RunTiming& timing, const Trajectory&) override {
    builder_.add_run(run, timing);
  }
  ResultTable finish() { return builder_.finish(); }

 private:
  TableBuilder builder_;
};

/// The options as sections of an .ini: for checking them, and for the manifest.
IniFile ini_of(const Methods& methods, const Options& options) {
  CampaignOptions campaign;
  campaign.seed = options.seed;
  campaign.repetitions = options.repetitions;
  campaign.metrics = options.metrics;
  campaign.descriptors = options.descriptors;
  campaign.exact_confinement = options.exact_confinement;
  campaign.safe_distance = options.safe_distance;
  campaign.setup.robot = options.robot;
  campaign.setup.sensor = options.sensor;
  campaign.setup.odometry = options.odometry;
  campaign.setup.simulation = options.simulation;
  campaign.setup.deadline = options.limits.deadline;
  campaign.limits = options.limits;
  IniFile ini = campaign_ini(campaign, "options ");
  std::vector<std::string> names;
  for (const NamedMethod& method : methods.list()) names.push_back(method.name);
  ini.set("campaign", "methods", join(names, ", "));
  return ini;
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
  if (methods.list().empty()) throw usage_error("evaluate", "no method given", "Methods::add()");
  if (scenarios.empty()) throw usage_error("evaluate", "no scenario given", "generate()");
  const IniFile ini = ini_of(methods, options);
  Campaign campaign{read_campaign_options(ini), without_duplicates(scenarios), methods.list(),
                    options.planner.get()};
  campaign.options.reference_gap = options.reference_gap;
  campaign.options.record.trajectories = StoredTrajectories::None;
  if (!options.in_process) check_methods(campaign);
  TableSink sink(campaign.options);
  CallbackProgress progress(options);
  run_campaign(campaign, sink, {options.workers, progress, options.cancel, options.in_process});
  ResultTable table = sink.finish();
  table.manifest = {
      {"campaign", campaign.options.name},    {"campaign.ini", ini.canonical_text()},
      {"seed", std::to_string(options.seed)}, {"version.slalom", version()},
      {"version.mrpt", mrpt_version()},       {"version.compiler", compiler_version()}};
  return table;
}

std::string cross_table(const ResultTable& table, const std::string& rows,
                        const std::vector<std::string>& columns, double confidence) {
  AnalysisOptions analysis;
  analysis.confidence = confidence;
  std::string text;
  for (const CrossTable& one : build_cross_tables(table, parse_bin_specs(rows), columns, analysis))
    text += (text.empty() ? "" : "\n") + render_cross_table_text(one);
  return text;
}

}  // namespace slalom
