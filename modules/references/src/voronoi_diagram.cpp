#include <slalom/references/voronoi_diagram.h>

namespace slalom {

/// On the diagram the nearest obstacles lie in different directions, so the slope of d is below 1:
/// it is the cosine of half the angle between these directions. 0.8 excludes angles below 74
/// degrees, such as between the cells of one rough wall.
bool is_on_ridge(const Occupancy& cells, const DistanceField& field, int cx, int cy) {
  constexpr double kMaxSlope = 0.8;
  const auto d = [&](int x, int y) { return cells.inside(x, y) ? field.at_center(x, y) : 0.0; };
  const double rise_x = d(cx + 1, cy) - d(cx - 1, cy), rise_y = d(cx, cy + 1) - d(cx, cy - 1);
  const double max_rise = kMaxSlope * 2 * cells.resolution();
  return rise_x * rise_x + rise_y * rise_y < max_rise * max_rise;
}

std::vector<std::uint8_t> voronoi_diagram(const World& world, double min_clearance) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  std::vector<std::uint8_t> diagram(cells.cells().size(), 0);
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      diagram[cells.index(x, y)] = !cells.occupied(x, y) &&
                                   field.at_center(x, y) >= min_clearance &&
                                   is_on_ridge(cells, field, x, y);
  return diagram;
}

}  // namespace slalom
