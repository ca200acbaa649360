#pragma once

#include "family.h"

#include <slalom/generation/map_window.h>

namespace slalom {

/// The map that a family's options name. Throws Error (Usage) where none is named or the shares of
/// cells contradict each other, and what the loader throws.
MapWindows load_windows(const FamilySection& section, const MapWindowOptions& options,
                        const EndsOptions& ends);

}  // namespace slalom
