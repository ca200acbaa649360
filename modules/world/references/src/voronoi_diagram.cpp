// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/references/voronoi_diagram.h>

namespace slalom {

/// On the diagram the nearest obstacles lie in different directions, so the slope of d is below 1:
/// it is the cosine of half the angle between these directions. 0.8 excludes angles below 74
/// degrees, such as between the cells of one rough wall.
void find_ridge(const DistanceField& field, const Occupancy& cells, int y, std::uint8_t* ridge) {
  constexpr double kMaxSlope = 0.8;
  const double max_rise = kMaxSlope * 2 * cells.resolution();
  const auto size_x = static_cast<std::size_t>(cells.size_x());
  const std::vector<float> border(size_x, 0.0F);
  const auto row = [&](int cy) {
    return cy < 0 || cy >= cells.size_y() ? border.data()
                                          : field.centers().begin() + cells.index(0, cy);
  };
  const float *below = row(y - 1), *here = row(y), *above = row(y + 1);
  const auto test = [&](std::size_t x, float left, float right) {
    const double rise_x = double{right} - double{left},
                 rise_y = double{above[x]} - double{below[x]};
    ridge[x] = rise_x * rise_x + rise_y * rise_y < max_rise * max_rise;
  };
  for (std::size_t x = 1; x + 1 < size_x; ++x) test(x, here[x - 1], here[x + 1]);
  const std::size_t last = size_x - 1;
  test(0, 0, size_x > 1 ? here[1] : 0);
  if (last > 0) test(last, here[last - 1], 0);
}

std::vector<std::uint8_t> voronoi_diagram(const World& world, double min_clearance) {
  const Occupancy& cells = world.occupancy();
  const DistanceField& field = world.distance_field();
  std::vector<std::uint8_t> diagram(cells.cells().size(), 0);
  for (int y = 0; y < cells.size_y(); ++y) {
    std::uint8_t* row = &diagram[cells.index(0, y)];
    find_ridge(field, cells, y, row);
    for (int x = 0; x < cells.size_x(); ++x)
      row[x] &= static_cast<std::uint8_t>(!cells.occupied(x, y) &&
                                          field.at_center(x, y) >= min_clearance);
  }
  return diagram;
}

}  // namespace slalom
