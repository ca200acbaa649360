// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/describe_scenario.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/io/scenario_list.h>

#include <vector>

namespace slalom {

/// Appends scenarios with their origins and values in one transaction: the GenerationSink that
/// stores to a list. Returns the indexes of the scenarios that the list already contained.
std::vector<std::size_t> keep_generated(ScenarioList& list,
                                        const std::vector<GeneratedScenario>& part);

/// The descriptor values of a world, to be stored with it. Thread-safe.
std::vector<KeyedValue> generated_values(const World& world, const DescribeOptions& options);

}  // namespace slalom
