// SPDX-License-Identifier: BSD-3-Clause
#include "../descriptor_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace slalom::descriptors {
namespace {

constexpr int kQuadrats = 8;  ///< along each side of W

std::size_t count_occupied(const std::uint8_t* first, std::ptrdiff_t count) {
  std::size_t occupied = 0;
  for (const std::uint8_t* cell = first; cell != first + count; ++cell) occupied += *cell;
  return occupied;
}

/// Occupied area (cells) of the quadrats, normalized to their mean size.
std::vector<double> areas_of_quadrats(const Occupancy& cells) {
  const int columns = std::min(kQuadrats, cells.size_x());
  const int rows = std::min(kQuadrats, cells.size_y());
  const auto border = [](std::int64_t i, int size, int parts) {
    return static_cast<int>(i * size / parts);
  };
  const double mean_size = static_cast<double>(cells.cells().size()) / (columns * rows);
  std::vector<double> areas;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x0 = border(column, cells.size_x(), columns);
      const int width = border(column + 1, cells.size_x(), columns) - x0;
      const int y0 = border(row, cells.size_y(), rows), y1 = border(row + 1, cells.size_y(), rows);
      std::size_t occupied = 0;
      for (int y = y0; y < y1; ++y)
        occupied += count_occupied(cells.cells().data() + cells.index(x0, y), width);
      areas.push_back(static_cast<double>(occupied) * mean_size /
                      (static_cast<double>(width) * (y1 - y0)));
    }
  return areas;
}

/// The number of differing cells of two runs.
std::size_t count_changes(const std::uint8_t* a, const std::uint8_t* b, std::ptrdiff_t count) {
  std::size_t changes = 0;
  for (std::ptrdiff_t i = 0; i < count; ++i) changes += a[i] ^ b[i];
  return changes;
}

/// Perimeter (cells) of the occupied cells, including the border of W.
std::size_t perimeter_of(const Occupancy& cells) {
  const int size_x = cells.size_x(), size_y = cells.size_y();
  const auto row = [&](int y) { return cells.cells().data() + cells.index(0, y); };
  std::size_t sides = count_occupied(row(0), size_x) + count_occupied(row(size_y - 1), size_x);
  for (int y = 0; y < size_y; ++y) {
    sides += row(y)[0] + std::size_t{row(y)[size_x - 1]};
    sides += count_changes(row(y), row(y) + 1, size_x - 1);
    if (y > 0) sides += count_changes(row(y - 1), row(y), size_x);
  }
  return sides;
}

/// Area (cells) of a disc with the same ratio of area to perimeter. The perimeter of a rasterized
/// isotropic shape is 4 / pi times that of the shape.
double grain_area(const Occupancy& cells) {
  const double perimeter = 0.25 * M_PI * static_cast<double>(perimeter_of(cells));
  const double radius = 2 * static_cast<double>(cells.count_occupied()) / perimeter;
  return M_PI * radius * radius;
}

}  // namespace

std::string quadrats(const DescriptorContext&) {
  return "quadrats=" + std::to_string(kQuadrats);
}

/// Variance / mean of the occupied area over k x k quadrats, with the area in units of grains:
/// discs with the same ratio of area to perimeter as the obstacles. So it has a limit for small
/// cells, which is 1 for equal, independently placed discs that are small relative to a quadrat.
Value clustering(const DescriptorContext& context) {
  const Occupancy& cells = context.world.occupancy();
  const std::vector<double> areas = areas_of_quadrats(cells);
  if (areas.size() < 2) return Value::na("fewer than two quadrats");
  double sum = 0, squares = 0;
  for (const double area : areas) sum += area;
  if (sum == 0) return Value::na("no obstacles");
  const double mean = sum / static_cast<double>(areas.size());
  for (const double area : areas) squares += (area - mean) * (area - mean);
  const double variance = squares / (static_cast<double>(areas.size()) - 1);
  return Value::of(variance / mean / grain_area(cells));
}

}  // namespace slalom::descriptors
