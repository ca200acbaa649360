#pragma once

#include <slalom/commands/describe_scenario.h>
#include <slalom/commands/list_command.h>

#include <string>
#include <vector>

namespace slalom {

/// The keys under which describe_scenario() keeps the values of these descriptors, for every kind
/// of scenario: what selections and indexes ask for.
DescriptorView descriptor_view(const std::vector<std::string>& ids, const DescribeOptions& options);

/// Ids of all descriptors, in the order of the documents.
std::vector<std::string> descriptor_ids();

/// Computes and keeps the values of options.ids that the list lacks. Keeps them a few scenarios at
/// a time, so that little is lost when the program is killed. `progress` must outlive it.
ListCommandPtr make_describe_list(ScenarioList& list, DescribeOptions options, Progress& progress);

}  // namespace slalom
