// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "failure_files.h"

#include <slalom/report/reported_cluster.h>

#include <string>
#include <vector>

namespace slalom {

constexpr char kExaminedResults[] = "/examined.results";  ///< in the output folder

/// Runs the method and its witnesses in the smallest scenarios, the originals and the neighbors
/// (examined.scenarios, examined.results), and writes the report of these runs (index.html) with a
/// page for each cluster of failures. Without failures it removes these files of an earlier search.
/// Throws Interrupted, Error.
std::vector<ReportedCluster> write_cluster_report(const std::vector<Failure>& failures,
                                                  const FalsifyCampaign& campaign,
                                                  const FalsifyArguments& arguments);

/// Text for people: the distinctive features of each cluster, and the path of the report.
std::string clusters_text(const std::vector<ReportedCluster>& clusters, const std::string& folder);

}  // namespace slalom
