// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/coverage.h>
#include <slalom/io/scenario_list.h>

#include <string>

namespace slalom {

/// Appends the scenarios of a coverage generation with their values in one transaction. Each is
/// tagged with its bin, "bin_2_4" for the third bin of the first descriptor and the fifth of the
/// second; its generator is "coverage". The table of bins is stored as note "coverage".
void keep_covered(ScenarioList& list, const CoveragePlan& plan, const CoverageResult& result);

}  // namespace slalom
