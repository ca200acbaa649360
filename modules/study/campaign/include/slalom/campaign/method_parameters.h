// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>

#include <vector>

namespace slalom {

/// The parameters that a method declares for tuning, built once in a process of its own. Throws
/// Error (Usage) if it cannot be built, or for numbers that are not finite.
std::vector<TunableParameter> tunable_parameters(const NamedMethod& method,
                                                 const CampaignOptions& options);

}  // namespace slalom
