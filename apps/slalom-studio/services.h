// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/services.h>

namespace slalom {

/// The import and export functions for the window.
StudioServices make_services();

}  // namespace slalom
