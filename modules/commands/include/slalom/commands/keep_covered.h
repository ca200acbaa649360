#pragma once

#include <slalom/generation/coverage.h>
#include <slalom/io/scenario_list.h>

#include <string>

namespace slalom {

/// Appends covered scenarios with their values in one step. Each is tagged with its bin, "bin_2_4"
/// for the third bin of the first descriptor and the fifth of the second; its generator is
/// "coverage". Note "coverage" keeps the table of bins.
void keep_covered(ScenarioList& list, const CoveragePlan& plan, const CoverageResult& result);

}  // namespace slalom
