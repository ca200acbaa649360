// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/falsification/cluster_report.h>
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

class Examiner {
 public:
  Examiner(const FalsificationSetup& setup, const std::string& folder)
      : setup_(setup), folder_(folder) {}

  Examination examine(const std::vector<Failure>& failures) {
    result_.examined = {setup_.method.name, setup_.repetition, {}};
    for (const Failure& failure : failures) add(failure);
    return std::move(result_);
  }

 private:
  const FalsificationSetup& setup_;
  const std::string& folder_;
  Examination result_;
  std::set<std::string> hashes_;

  void add(const Failure& failure) {
    const Scenario& smallest = failure.small.scenario;
    ExaminedFailure examined;
    examined.found = failure.origin;
    examined.command = show_command(failure, setup_, folder_);
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
    result_.examined.failures.push_back(std::move(examined));
  }

  void add_scenario(Scenario scenario, const std::string& role) {
    if (!hashes_.insert(scenario.hash()).second) return;
    result_.scenarios.push_back(std::move(scenario));
    result_.roles.push_back(role);
  }
};

}  // namespace

Examination examination_of(const std::vector<Failure>& failures, const FalsificationSetup& setup,
                           const std::string& folder) {
  return Examiner(setup, folder).examine(failures);
}

void write_scenarios(const Examination& examination, const std::string& path) {
  ScenarioList::write(path, [&examination](ScenarioList& list) {
    for (std::size_t i = 0; i < examination.scenarios.size(); ++i)
      list.add(examination.scenarios[i], {"", std::nullopt, {examination.roles[i]}});
  });
}

std::vector<ReportedCluster> write_cluster_report(const Examination& examination,
                                                  const std::string& folder) {
  const std::string results = folder + "/" + kExaminedResults;
  const ResultTable runs = read_results(results);
  ReportOptions options = report_options(runs);
  options.clusters =
      explain_failures(ResultFile::open(results), runs, options, examination.examined);
  write_file_atomically(folder + "/" + kExaminedFailures, to_json(examination.examined));
  write_report(results, runs, options, folder);
  return options.clusters;
}

void remove_cluster_report(const std::string& folder) {
  remove_report(folder);
  std::error_code not_there;
  for (const char* file : {kExaminedResults, kExaminedFailures, kExaminedScenarios})
    std::filesystem::remove(folder + "/" + file, not_there);
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
