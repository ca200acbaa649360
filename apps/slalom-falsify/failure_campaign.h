// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arguments.h"

#include <slalom/falsification/cluster_report.h>

#include <string>
#include <vector>

namespace slalom {

/// Writes write_failures() and failures.ini, a campaign that runs method and witnesses in the
/// smallest scenarios, into the output folder, which is created. Throws Error (Job).
void write_output(const std::vector<Failure>& failures, const FalsifyCampaign& campaign,
                  const std::string& folder, const std::string& search = "");

/// Runs the method and its witnesses in the smallest scenarios, the originals and the neighbors,
/// and writes write_cluster_report() of these runs. Without failures it removes the report of an
/// earlier search. Throws Interrupted, Error.
std::vector<ReportedCluster> report_clusters(const std::vector<Failure>& failures,
                                             const FalsifyCampaign& campaign,
                                             const FalsifyArguments& arguments);

}  // namespace slalom
