// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/explain.h>
#include <slalom/falsification/failure.h>

#include <string>
#include <vector>

namespace slalom {

// Files of an output folder.
constexpr char kExaminedScenarios[] = "examined.scenarios";
constexpr char kExaminedResults[] = "examined.results";
constexpr char kExaminedFailures[] = "examined.json";

/// The scenarios in which the method and its witnesses are to run for a report of clusters, each
/// once: the smallest ones, the originals and the neighbors.
struct Examination {
  std::vector<Scenario> scenarios;
  std::vector<std::string> roles;  ///< of each scenario: "failure", "original" or "neighbor"
  ExaminedFailures examined;
};

/// `folder`: that of write_failures(), for the commands that repeat a failure.
Examination examination_of(const std::vector<Failure>& failures, const FalsificationSetup& setup,
                           const std::string& folder);

/// Writes the scenarios as a list, with their roles as tags. Throws Error (Job).
void write_scenarios(const Examination& examination, const std::string& path);

/// Writes the report (index.html) of the runs in FOLDER/examined.results, with a page for each
/// cluster of failures, and examined.json. Throws Error (File) for damaged results, Error (Job)
/// where a run is missing or a file cannot be written.
std::vector<ReportedCluster> write_cluster_report(const Examination& examination,
                                                  const std::string& folder);

/// Removes the files of such a report and of its runs, if there are any. Throws Error (Job).
void remove_cluster_report(const std::string& folder);

/// Text for people: the distinctive features of each cluster, and the path of the report.
std::string clusters_text(const std::vector<ReportedCluster>& clusters, const std::string& folder);

}  // namespace slalom
