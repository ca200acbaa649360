#pragma once

#include <slalom/gui/studio_services.h>

namespace slalom {

/// The formats of this program, for the window.
StudioServices make_services();

}  // namespace slalom
