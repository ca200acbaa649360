// SPDX-License-Identifier: BSD-3-Clause
#include "play_window.h"

#include <slalom/core/version.h>

namespace slalom {

void show_run(const RecordedRun&, const Scenario&, const CampaignOptions&, const std::string&,
              const std::string&) {
  throw not_built("slalom-replay play --gui", "SLALOM_WITH_GUI");
}

}  // namespace slalom
