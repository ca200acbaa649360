// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The loops over the cells of a clearance map, vectorized for the processor at run time; the same
/// bits on every processor.
namespace reactive {

/// Kernels process complete vectors: arrays end with unused elements up to a multiple of this.
constexpr std::size_t kMaxLanes = 16;

constexpr std::size_t padded(std::size_t count) {
  return (count + kMaxLanes - 1) / kMaxLanes * kMaxLanes;
}

/// A square grid of `side` rows and columns of cells of `resolution` m, aligned to the frame.
struct GridFrame {
  double resolution = 0.05;
  int side = 0;
  Point origin;  ///< lower left corner
};

/// Sets each cell to the distance of its center to the closest point, at most `band` (m). `cells`
/// has padded(side * side) elements or more.
void fill_clearances(const GridFrame& frame, double band, const std::vector<Point>& points,
                     std::vector<float>& cells);

/// Clearances at positions (x, y), bilinear between cell centers; `band` outside of these. Arrays
/// have padded(count) elements.
void interpolate(const GridFrame& frame, double band, const float* cells, const double* x,
                 const double* y, std::size_t count, double* clearances);

/// Weight of a path through a cell by its clearance, in units of `unit`: 0 below `closed`,
/// otherwise from 1 at `comfort` to 1 + `slope` at `comfort - span`, rounded down.
struct WeightRule {
  double closed = 0, comfort = 0, span = 1, slope = 0;
  double unit = 1;  ///< of a weight of 1
};

/// Applies `rule` to `count` clearances, at most `max_weight`; arrays have padded(count) elements.
/// `costs` becomes `closed_cost` where the weight is 0 and `open_cost` elsewhere.
void fill_weights(const WeightRule& rule, const float* clearances, std::size_t count,
                  std::int32_t max_weight, std::int32_t closed_cost, std::int32_t open_cost,
                  std::int32_t* weights, std::int32_t* costs);

}  // namespace reactive
