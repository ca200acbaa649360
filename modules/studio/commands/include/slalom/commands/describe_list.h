// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/describe_scenario.h>
#include <slalom/commands/list_command.h>

#include <string>
#include <vector>

namespace slalom {

/// The keys under which describe_scenario() stores the values of these descriptors, for every kind
/// of scenario. Used by selections and indexes.
DescriptorView descriptor_view(const std::vector<std::string>& ids, const DescribeOptions& options);

/// Computes and stores the missing values of options.ids. Values are committed in batches, so that
/// little is lost when the program is killed. `progress` must outlive the command.
ListCommandPtr make_describe_list(ScenarioList& list, DescribeOptions options, Progress& progress);

}  // namespace slalom
