#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/geometry.h>

#include <utility>
#include <vector>

namespace slalom {

/// The rectangle with these corners.
Polygon rectangle(double x_min, double y_min, double x_max, double y_max);

/// Two places that a wall parts, by their numbers.
using Neighbours = std::pair<int, int>;

/// Which walls are opened so that every place is joined to every other: just enough, chosen at
/// random (Kruskal's tree over the walls in random order), and `extra_share` of the rest, rounded,
/// as loops. The walls must be able to join all places.
std::vector<bool> open_walls(RandomEngine& engine, int places, const std::vector<Neighbours>& walls,
                             double extra_share);

}  // namespace slalom
