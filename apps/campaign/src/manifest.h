#pragma once

#include <slalom/campaign/campaign.h>
#include <slalom/results/run_record.h>

namespace slalom {

/// What is needed to repeat a campaign: its effective .ini and seed, the hash of its scenarios, the
/// versions of what it was built with, the hash of every method's library.
Manifest make_manifest(const Campaign& campaign);

}  // namespace slalom
