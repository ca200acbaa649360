// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

#include <vector>

namespace slalom {

/// Four points about each point of a lattice of 1 m, or of a cell if that is larger, centered in
/// the workspace: as many as fit, at least one per axis; row by row. They are shifted along both
/// axes by a fraction of a cell, so that none is on a line between cells.
std::vector<mrpt::math::TPoint2D> lattice_points(const Occupancy& cells);

}  // namespace slalom
