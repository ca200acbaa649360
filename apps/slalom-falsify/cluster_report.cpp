// SPDX-License-Identifier: BSD-3-Clause
#include "cluster_report.h"

#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/falsification/explain.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/report/report.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace slalom {
namespace {

constexpr std::size_t kDepartures = 3;  // of the members of a cluster that are printed

// In the output folder.
constexpr char kExaminedScenarios[] = "/examined.scenarios";
constexpr char kExaminedFailures[] = "/examined.json";

/// The scenarios to run, each once, and their roles in the failures.
class Examination {
 public:
  Examination(const std::vector<Failure>& failures, const TestBench& bench,
              const std::string& folder)
      : examined_{bench.method.name, bench.repetition, {}} {
    for (const Failure& failure : failures) add(failure, bench, folder);
  }
  const std::vector<Scenario>& scenarios() const { return scenarios_; }
  const ExaminedFailures& examined() const { return examined_; }

  void write(const std::string& path) const {
    ScenarioList::write(path, [this](ScenarioList& list) {
      for (std::size_t i = 0; i < scenarios_.size(); ++i)
        list.add(scenarios_[i], {"", std::nullopt, {roles_[i]}});
    });
  }

 private:
  std::vector<Scenario> scenarios_;
  std::vector<std::string> roles_;  ///< tags, parallel to the scenarios
  std::set<std::string> hashes_;
  ExaminedFailures examined_;

  void add(const Failure& failure, const TestBench& bench, const std::string& folder) {
    const Scenario& smallest = failure.small.scenario;
    ExaminedFailure examined;
    examined.found = failure.origin;
    examined.command = show_command(failure, bench, folder);
    examined.smallest = smallest.hash();
    examined.compared = failure.is_original_compared ? failure.original.hash() : smallest.hash();
    examined.obstacles = failure.small.parts_after;
    examined.bottleneck_width = failure.small.fairness.geometry.bottleneck;
    examined.independent = failure.independent;
    add_scenario(smallest, "failure");
    add_scenario(failure.original.renamed(smallest.name() + "_original"), "original");
    for (std::size_t i = 0; i < failure.neighbors.size(); ++i) {
      const std::string name = smallest.name() + "_neighbor_" + std::to_string(i + 1);
      examined.neighbors.push_back(failure.neighbors[i].hash());
      add_scenario(failure.neighbors[i].renamed(name), "neighbor");
    }
    examined_.failures.push_back(std::move(examined));
  }

  void add_scenario(Scenario scenario, const std::string& role) {
    if (!hashes_.insert(scenario.hash()).second) return;
    scenarios_.push_back(std::move(scenario));
    roles_.push_back(role);
  }
};

ResultTable run_examination(const Examination& examination, const FalsifyCampaign& campaign,
                            const FalsifyArguments& arguments, const std::string& results) {
  const std::string list = arguments.output + kExaminedScenarios;
  examination.write(list);
  CampaignConfig config = read_campaign(ini_of_list(campaign, list, RecordedRuns::None));
  config.privileged = campaign.config.privileged;
  config.options.adapt_to(examination.scenarios());
  CampaignArguments run = arguments.campaign;
  run.quiet = true;  // a part of the job, which takes seconds
  run.existing = ExistingResults::Overwrite;
  ResultFile file = open_campaign_results(config, run, examination.scenarios(), results);
  const CampaignReport report =
      run_campaign_program(config, run, examination.scenarios(), std::move(file));
  if (!report.complete || InterruptGuard::raised())
    throw Interrupted("the same command writes the report");
  if (!report.problem.empty()) throw job_error(results, report.problem);
  return read_results(results);
}

}  // namespace

std::vector<ReportedCluster> write_cluster_report(const std::vector<Failure>& failures,
                                                  const FalsifyCampaign& campaign,
                                                  const FalsifyArguments& arguments) {
  const std::string& folder = arguments.output;
  const std::string results = folder + kExaminedResults;
  if (failures.empty()) {
    remove_report(folder);
    std::error_code not_there;
    for (const std::string& file :
         {results, folder + kExaminedFailures, folder + kExaminedScenarios})
      std::filesystem::remove(file, not_there);
    return {};
  }
  const Examination examination(failures, campaign.bench, folder);
  const ResultTable runs = run_examination(examination, campaign, arguments, results);
  ReportOptions options = report_options(runs);
  options.clusters =
      explain_failures(ResultFile::open(results), runs, options, examination.examined());
  write_file_atomically(folder + kExaminedFailures, to_json(examination.examined()));
  write_report(results, runs, options, folder);
  return options.clusters;
}

std::string clusters_text(const std::vector<ReportedCluster>& clusters, const std::string& folder) {
  std::string text;
  for (const ReportedCluster& cluster : clusters) {
    const std::size_t size = cluster.members.size();
    text += "\n" + count_text(size, "failure") + ": " + cluster.name + "\n";
    for (const std::string& statement : cluster.statements) text += "  " + statement + "\n";
    text += "  " + cluster.basis + "\n";
    for (std::size_t i = 0; i < std::min(size, kDepartures); ++i)
      if (!cluster.members[i].departure.empty()) text += "  " + cluster.members[i].departure + "\n";
  }
  return clusters.empty() ? "" : text + "\nReport: " + folder + "/index.html\n";
}

}  // namespace slalom
