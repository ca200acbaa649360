// SPDX-License-Identifier: BSD-3-Clause
#include "../descriptor_parameters.h"
#include "barn_field.h"

#include <slalom/core/math.h>

#include <cmath>

namespace slalom::descriptors {
namespace {

/// Number of free cells on a ray, including the first, and whether it ends at an obstacle or at the
/// border of the map.
struct Ray {
  int cells = 0;
  bool ends_at_obstacle = false;
};

Ray cast(const BarnField& field, int row, int column, int dr, int dc) {
  Ray ray;
  while (field.inside(row, column)) {
    if (field.blocked(row, column)) {
      ray.ends_at_obstacle = true;
      break;
    }
    ++ray.cells;
    row += dr;
    column += dc;
  }
  return ray;
}

/// BARN's average visibility: the mean over the rays in 8 directions that end at an obstacle. In
/// the 2021 version cells count 1 or sqrt 2 by direction; in the 2020 version each counts 1 and the
/// mean is rounded down.
std::optional<double> visibility(const BarnField& field, int row, int column, int year) {
  double length = 0;
  int cells = 0, rays = 0;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc) {
      if (dr == 0 && dc == 0) continue;
      const Ray ray = cast(field, row, column, dr, dc);
      if (!ray.ends_at_obstacle) continue;
      ++rays;
      cells += ray.cells;
      length += ray.cells * math::hypot(dr, dc);
    }
  if (rays == 0) return std::nullopt;
  if (year == 2020) {
    const int mean = cells / rays;  // rounded down, as published
    return mean;
  }
  return length / rays;
}

}  // namespace

std::string barn_version(const DescriptorContext& context) {
  return "barn_visibility=" + std::to_string(context.barn_visibility);
}

Value barn_visibility(const DescriptorContext& context) {
  const BarnField& field = barn_field(context);
  return field.mean([&](int r, int c) { return visibility(field, r, c, context.barn_visibility); },
                    "no ray from the path ends at an obstacle");
}

}  // namespace slalom::descriptors
