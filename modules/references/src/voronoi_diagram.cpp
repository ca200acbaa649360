#include <slalom/references/voronoi_diagram.h>

namespace slalom {

/// On the diagram the nearest obstacles lie on different sides, so the slope of d falls below 1: it
/// is the cosine of half the angle between the directions to them. 0.8 leaves out angles under 74
/// degrees, such as between the cells of one rough wall.
bool is_on_ridge(const Occupancy& cells, const DistanceField& field, int cx, int cy) {
  constexpr double kMaxSlope = 0.8;
  const auto d = [&](int x, int y) { return cells.inside(x, y) ? field.at_center(x, y) : 0.0; };
  const double rise_x = d(cx + 1, cy) - d(cx - 1, cy), rise_y = d(cx, cy + 1) - d(cx, cy - 1);
  const double most = kMaxSlope * 2 * cells.resolution();
  return rise_x * rise_x + rise_y * rise_y < most * most;
}

std::vector<std::uint8_t> voronoi_diagram(const World& world, double least_clearance) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  std::vector<std::uint8_t> on(cells.cells().size(), 0);
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      on[cells.index(x, y)] = !cells.occupied(x, y) && field.at_center(x, y) >= least_clearance &&
                              is_on_ridge(cells, field, x, y);
  return on;
}

}  // namespace slalom
