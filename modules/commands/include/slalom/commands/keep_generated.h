#pragma once

#include <slalom/commands/describe_scenario.h>
#include <slalom/generation/generate_mix.h>
#include <slalom/io/scenario_list.h>

#include <vector>

namespace slalom {

/// Appends scenarios with their origins and values in one step: what a GenerationSink does that
/// keeps a list. The indexes of those whose content was there before.
std::vector<std::size_t> keep_generated(ScenarioList& list,
                                        const std::vector<GeneratedScenario>& part);

/// The values of a world's descriptors, to be kept with it; for many threads at once.
std::vector<GeneratedValue> generated_values(const World& world, const DescribeOptions& options);

}  // namespace slalom
