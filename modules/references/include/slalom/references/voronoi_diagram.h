#pragma once

#include <slalom/scenario/world.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// Whether a free cell lies on the generalised Voronoi diagram of an occupancy: the ridge of its
/// distance field, on which the safest path runs.
bool is_on_ridge(const Occupancy& cells, const DistanceField& field, int cx, int cy);

/// The cells of the diagram, row-major, 1 on it, 0 beside it: those on the ridge with at least
/// `least_clearance` (m) at their centre. Nearer than about two cells to obstacles the cells' own
/// corners make ridges, too.
std::vector<std::uint8_t> voronoi_diagram(const World& world, double least_clearance);

}  // namespace slalom
