// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// Finds the cells of row `y` on the ridge of the distance field, on which the generalized Voronoi
/// diagram lies: `ridge` is set to 1 there, to 0 elsewhere, for all cells of the row. It is
/// undefined for occupied cells.
void find_ridge(const DistanceField& field, const Occupancy& cells, int y, std::uint8_t* ridge);

/// The cells of the diagram, row-major, 1 on it, 0 elsewhere: those on the ridge with at least
/// `min_clearance` (m) at their center. Closer than about two cells to obstacles the corners of
/// cells cause ridges, too.
std::vector<std::uint8_t> voronoi_diagram(const World& world, double min_clearance);

}  // namespace slalom
