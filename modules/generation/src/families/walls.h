// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/geometry.h>

#include <utility>
#include <vector>

namespace slalom {

/// The rectangle with these corners.
Polygon rectangle(double x_min, double y_min, double x_max, double y_max);

/// Indexes of the two cells on either side of a wall.
using CellPair = std::pair<int, int>;

/// Selects the walls to open so that all cells are connected: a random spanning tree (Kruskal's
/// algorithm over the walls in random order), and `extra_fraction` of the rest, rounded, as loops.
/// The graph of cells and walls must be connected.
std::vector<bool> open_walls(RandomEngine& engine, int cells, const std::vector<CellPair>& walls,
                             double extra_fraction);

}  // namespace slalom
