// SPDX-License-Identifier: BSD-3-Clause
#include "barn_field.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom::descriptors {
namespace {

/// Number of consecutive free cells from the neighbor of a cell on.
int free_cells(const BarnField& field, int row, int column, int dr, int dc) {
  int cells = 0;
  for (int r = row + dr, c = column + dc; field.inside(r, c) && !field.blocked(r, c);
       r += dr, c += dc)
    ++cells;
  return cells;
}

/// BARN's characteristic dimension: the minimum over 4 axes of the free length on both sides
/// (without the cell itself; a diagonal cell counts sqrt 2). 0 in an obstacle.
double characteristic_dimension(const BarnField& field, int row, int column) {
  if (field.blocked(row, column)) return 0;
  constexpr int kAxes[][2] = {{0, 1}, {1, 1}, {1, 0}, {1, -1}};
  double dimension = std::numeric_limits<double>::infinity();
  for (const auto& [dr, dc] : kAxes) {
    const int cells =
        free_cells(field, row, column, dr, dc) + free_cells(field, row, column, -dr, -dc);
    dimension = std::min(dimension, cells * math::hypot(dr, dc));
  }
  return dimension;
}

}  // namespace

Value barn_characteristic_dimension(const DescriptorContext& context) {
  const BarnField& field = barn_field(context);
  return field.mean([&](int r, int c) { return characteristic_dimension(field, r, c); },
                    "no points");
}

}  // namespace slalom::descriptors
