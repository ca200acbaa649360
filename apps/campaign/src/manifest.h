// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/results/run_record.h>

namespace slalom {

/// The .ini with all values that may change a result, including the defaults of absent keys. Keys
/// that only select scenarios, tables or recordings are not part of it.
std::string effective_ini(const IniFile& ini, const CampaignConfig& config);

/// The information needed to reproduce a campaign: its effective .ini and seed, the hash of its
/// scenarios, the versions of its dependencies, the hashes of the files of methods, the stopping
/// rule, and the identity that follows from these (campaign_identity()).
Manifest make_manifest(const CampaignConfig& config, const std::vector<Scenario>& scenarios,
                       const std::optional<StoppingRule>& rule);

}  // namespace slalom
