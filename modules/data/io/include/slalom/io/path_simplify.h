// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/path.h>

namespace slalom {

/// The path without vertices within `tolerance` (m) of the simplified line (Douglas and Peucker
/// 1973). Keeps the end points. For pictures only.
Path simplify(const Path& path, double tolerance);

}  // namespace slalom
