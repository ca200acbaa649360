// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "family.h"

#include <slalom/generation/map_window.h>

namespace slalom {

/// Loads the map of a family's options. Throws Error (Usage) if the options name no map or
/// contradictory fractions of cells, and what the loader throws.
MapWindows load_windows(const FamilyChecks& checks, const MapWindowOptions& options,
                        const StartGoalOptions& start_goal);

}  // namespace slalom
