#pragma once

#include <slalom/scenario/world.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// Whether a free cell lies on the generalized Voronoi diagram of an occupancy: the ridge of its
/// distance field, on which the safest path runs.
bool is_on_ridge(const Occupancy& cells, const DistanceField& field, int cx, int cy);

/// The cells of the diagram, row-major, 1 on it, 0 elsewhere: those on the ridge with at least
/// `min_clearance` (m) at their center. Closer than about two cells to obstacles the corners of
/// cells cause ridges, too.
std::vector<std::uint8_t> voronoi_diagram(const World& world, double min_clearance);

}  // namespace slalom
