// SPDX-License-Identifier: BSD-3-Clause
#include "disc_problems.h"
#include "tangent_graph.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

void scatter(RandomEngine& engine, double density, Occupancy& cells) {
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      if (uniform_real(engine, 0, 1) < density) cells.set_occupied(x, y, true);
}

void add_block(RandomEngine& engine, Occupancy& cells) {
  const int x0 = uniform_int(engine, 0, cells.size_x() - 1);
  const int y0 = uniform_int(engine, 0, cells.size_y() - 1);
  const int x1 = std::min(cells.size_x(), x0 + uniform_int(engine, 1, 5));
  const int y1 = std::min(cells.size_y(), y0 + uniform_int(engine, 1, 5));
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) cells.set_occupied(x, y, true);
}

void add_disc(RandomEngine& engine, Occupancy& cells) {
  const double cx = uniform_real(engine, 0, cells.size_x());
  const double cy = uniform_real(engine, 0, cells.size_y());
  const double radius = uniform_real(engine, 1, 5);
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      if (std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius) cells.set_occupied(x, y, true);
}

void add_wall_with_door(RandomEngine& engine, double radius, Occupancy& cells) {
  const int door = static_cast<int>(std::ceil(2 * radius - 1e-6));
  const int first = uniform_int(engine, 0, std::max(0, cells.size_y() - door));
  for (int y = 0; y < cells.size_y(); ++y)
    if (y < first || y >= first + door) cells.set_occupied(cells.size_x() / 2, y, true);
  scatter(engine, 0.01, cells);
}

TPoint2D random_point(RandomEngine& engine, const Occupancy& cells) {
  return {uniform_real(engine, 0, cells.size_x()), uniform_real(engine, 0, cells.size_y())};
}

/// False if no pair of free positions was drawn.
bool draw_start_goal(RandomEngine& engine, DiscProblem& problem) {
  const Occupancy& cells = problem.cells;
  const auto is_free = [&](const TPoint2D& a, const TPoint2D& b) {
    return is_far_from_occupied(cells, a, b, problem.radius - 1e-9);
  };
  for (int attempt = 0; attempt < 100; ++attempt) {
    TPoint2D start = random_point(engine, cells), goal = random_point(engine, cells);
    const int mode = uniform_int(engine, 0, 2);
    if (mode == 1) {
      start = {std::round(start.x), std::round(start.y)};
      goal = {std::round(goal.x), std::round(goal.y)};
    } else if (mode == 2) {
      start.x = problem.radius;
      goal.x = cells.size_x() - problem.radius;
    }
    if ((goal - start).norm() < 1 || !is_free(start, start) || !is_free(goal, goal)) continue;
    if (attempt < 60 && is_free(start, goal)) continue;  // straight paths are easy
    problem.start = start;
    problem.goal = goal;
    return true;
  }
  return false;
}

}  // namespace

Occupancy empty_cells(int size_x, int size_y) {
  return {size_x, size_y, kCellSize, TPoint2D(0, 0)};
}

Occupancy occupancy_of(const std::vector<std::string>& rows) {
  Occupancy cells = empty_cells(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < cells.size_y(); ++y)
    for (int x = 0; x < cells.size_x(); ++x)
      if (rows[rows.size() - 1 - static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#')
        cells.set_occupied(x, y, true);
  return cells;
}

DiscProblem random_problem(RandomEngine& engine) {
  // Multiples of half a cell, so that passages and contacts are exact; 0.25 m in cells of single
  // precision; diagonals.
  const double radii[] = {
      0.5, 1, 1.5, 2, 2.5, 0.7, 1.3, 2.06, std::sqrt(0.5), std::sqrt(2.0), 4.9999999255};
  constexpr int kRadii = static_cast<int>(sizeof radii / sizeof *radii);
  while (true) {
    const double radius = radii[uniform_int(engine, 0, kRadii - 1)];
    const int extra = radius > 4 ? 14 : 0;
    DiscProblem problem{
        empty_cells(uniform_int(engine, 9, 20) + extra, uniform_int(engine, 9, 20) + extra),
        radius,
        {},
        {}};
    const int kind = uniform_int(engine, 0, 3);
    if (kind == 0)
      scatter(engine, uniform_real(engine, 0.02, 0.18) / (radius * radius + 0.3), problem.cells);
    for (int i = uniform_int(engine, 2, 7); kind == 1 && i > 0; --i)
      add_block(engine, problem.cells);
    for (int i = uniform_int(engine, 1, 4); kind == 2 && i > 0; --i)
      add_disc(engine, problem.cells);
    if (kind == 3) add_wall_with_door(engine, radius, problem.cells);
    if (draw_start_goal(engine, problem)) return problem;
  }
}

DiscProblem transformed(const DiscProblem& problem, int symmetry) {
  const bool exchanges = (symmetry & 4) != 0;
  const int size_x = problem.cells.size_x(), size_y = problem.cells.size_y();
  DiscProblem result{exchanges ? empty_cells(size_y, size_x) : empty_cells(size_x, size_y),
                     problem.radius,
                     {},
                     {}};
  const auto moved = [&](TPoint2D p) {
    if ((symmetry & 1) != 0) p.x = size_x - p.x;
    if ((symmetry & 2) != 0) p.y = size_y - p.y;
    return exchanges ? TPoint2D(p.y, p.x) : p;
  };
  for (int y = 0; y < size_y; ++y)
    for (int x = 0; x < size_x; ++x) {
      const TPoint2D to = moved({x + 0.5, y + 0.5});
      if (problem.cells.occupied(x, y))
        result.cells.set_occupied(static_cast<int>(to.x), static_cast<int>(to.y), true);
    }
  result.start = moved(problem.start);
  result.goal = moved(problem.goal);
  return result;
}

}  // namespace slalom
