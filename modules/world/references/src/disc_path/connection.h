// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "open_rows.h"

namespace slalom::disc_path {

/// False proves that no path of the disc connects two free points (cells): no chain of open cells,
/// which touch at a side or a corner, does. Fills from both points in turns, so that the cost is
/// that of the smaller part, at most that of preparing all rows.
bool may_connect(const OpenRows& open, const Vector& start, const Vector& goal);

}  // namespace slalom::disc_path
