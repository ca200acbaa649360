#pragma once

#include <slalom/trajectory/path.h>

namespace slalom {

/// The path without vertices that lie within `tolerance` (m) of the line that is left (Douglas and
/// Peucker 1973); its ends stay. For pictures only.
Path simplify(const Path& path, double tolerance);

}  // namespace slalom
