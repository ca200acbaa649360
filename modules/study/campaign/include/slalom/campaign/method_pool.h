// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/workers/pool_options.h>

namespace slalom {

/// A pool for work items in which methods run, without limits of time. Throws Error (Usage) when
/// the kernel cannot confine processes as `limits` requires.
PoolOptions method_pool(const LimitsSection& limits, const WallClock& clock);

/// A pool for work items that are one run each, with all limits. Throws as method_pool().
PoolOptions pool_of_runs(const CampaignOptions& options, int workers);

/// The outcome of a run whose work item did not complete.
Outcome outcome_of(const WorkResult& result);

}  // namespace slalom
