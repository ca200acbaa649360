// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>
#include <slalom/scenario/occupancy.h>

#include <string>
#include <vector>

namespace slalom {

/// A problem in cells of kCellSize.
struct DiscProblem {
  Occupancy cells;
  double radius = 0;  ///< cells
  mrpt::math::TPoint2D start, goal;
};

constexpr double kCellSize = 0.05;  // m
constexpr double kContact = 1e-9;   // m, tolerated by collision checking

Occupancy empty_cells(int size_x, int size_y);

/// Rows of '#' and '.' from top to bottom.
Occupancy occupancy_of(const std::vector<std::string>& rows);

/// Scattered cells, blocks, discs, or a wall with a door of exactly the disc's diameter if that is
/// a multiple of the cell; start and goal free, anywhere, at vertices, or in contact with a wall.
DiscProblem random_problem(RandomEngine& engine);

/// One of the eight symmetries of a square: bit 0 mirrors x, bit 1 y, bit 2 exchanges both.
DiscProblem transformed(const DiscProblem& problem, int symmetry);

}  // namespace slalom
