// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/settings.h>

#include <map>
#include <string>

namespace slalom {

/// The bounds of the elements of Slalom Studio's window by id, in pixels: the list at the left,
/// descriptors below it; the scenario view at the right, results or the timeline of movers below it
/// if they are shown.
using WindowLayout = std::map<std::string, ScreenRect>;

/// The settings with panel sizes that fit into a window of this size. The scenario view is the
/// largest element of every window: panels shrink before it does.
StudioSettings with_fitted_panels(StudioSettings settings, int width, int height);

/// The panel below the scenario view.
enum class BelowView { Nothing, Timeline, Results };

/// Lays out the window with the panel sizes of `settings`, fitted to the window.
WindowLayout lay_out_window(int width, int height, const StudioSettings& settings,
                            BelowView below_view);

}  // namespace slalom
