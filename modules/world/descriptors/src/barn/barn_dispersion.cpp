// SPDX-License-Identifier: BSD-3-Clause
#include "barn_field.h"

namespace slalom::descriptors {
namespace {

struct Direction16 {
  int row, column;
};

/// The published order: by the angle, except that (-2, -1) and (-1, -2) are swapped.
constexpr Direction16 kDirections[] = {{0, 1},  {1, 2},  {1, 1},  {2, 1},   {1, 0},   {2, -1},
                                       {1, -1}, {1, -2}, {0, -1}, {-2, -1}, {-1, -1}, {-1, -2},
                                       {-1, 0}, {-2, 1}, {-1, 1}, {-1, 2}};

/// Number of steps of a ray within the radius of 3. A step of a 2:1 ray counts 2, as published only
/// if the 2 is positive.
constexpr int steps_of(const Direction16& d) {
  return d.row == 2 || d.column == 2 ? 2 : 3;
}

bool meets_obstacle(const BarnField& field, int row, int column, const Direction16& d) {
  for (int step = 1; step <= steps_of(d); ++step) {
    const int r = row + step * d.row, c = column + step * d.column;
    if (!field.inside(r, c)) return false;
    if (field.blocked(r, c)) return true;
  }
  return false;
}

/// BARN's dispersion: the number of changes between obstacle and no obstacle within 3 cells over
/// rays in 16 directions around the cell. 0 in an obstacle.
double dispersion(const BarnField& field, int row, int column) {
  if (field.blocked(row, column)) return 0;
  int changes = 0;
  bool before = meets_obstacle(field, row, column, kDirections[15]);
  for (const Direction16& direction : kDirections) {
    const bool meets = meets_obstacle(field, row, column, direction);
    changes += meets != before ? 1 : 0;
    before = meets;
  }
  return changes;
}

}  // namespace

Value barn_dispersion(const DescriptorContext& context) {
  const BarnField& field = barn_field(context);
  return field.mean([&](int r, int c) { return dispersion(field, r, c); }, "no points");
}

}  // namespace slalom::descriptors
