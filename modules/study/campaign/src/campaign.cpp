// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign.h>
#include <slalom/core/random.h>

namespace slalom {

std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario_hash,
                       int repetition) {
  return derive_seed(campaign_seed, "run/" + scenario_hash, static_cast<std::uint64_t>(repetition));
}

}  // namespace slalom
