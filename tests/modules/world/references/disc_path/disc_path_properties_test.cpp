// SPDX-License-Identifier: BSD-3-Clause
// The exact shortest path of a disc on random grids, compared with brute force.
#include "disc_problems.h"
#include "tangent_graph.h"

#include <slalom/references/disc_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

#if defined(SLALOM_SANITIZE)
constexpr int kGrids = 200, kSymmetricGrids = 200;
#else
constexpr int kGrids = 2000, kSymmetricGrids = 3000;
#endif

std::optional<DiscPath> solve(const DiscProblem& problem) {
  std::string reason;
  return shortest_disc_path(problem.cells, problem.radius * kCellSize,
                            problem.cells.to_world(problem.start.x, problem.start.y),
                            problem.cells.to_world(problem.goal.x, problem.goal.y), reason);
}

/// In cells; infinite without a path.
double length_of(const std::optional<DiscPath>& path) {
  return path ? path->length / kCellSize : std::numeric_limits<double>::infinity();
}

TEST(DiscPathProperties, LengthsAreThoseOfAFullTangentGraph) {
  RandomEngine engine(21);
  int bent = 0, none = 0;
  for (int trial = 0; trial < kGrids; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const double expected = tangent_graph_length(
        problem.cells, problem.radius - kContact / kCellSize, problem.start, problem.goal);
    const std::optional<DiscPath> path = solve(problem);
    ASSERT_EQ(path.has_value(), std::isfinite(expected)) << "trial " << trial;
    if (!path) {
      ++none;
      continue;
    }
    ASSERT_NEAR(length_of(path), expected, 1e-9 * expected) << "trial " << trial;
    bent += path->arcs.empty() ? 0 : 1;
  }
  EXPECT_GT(bent, kGrids / 2);
  EXPECT_GT(none, kGrids / 20);
}

TEST(DiscPathProperties, PolylinesAreFreeAndHardlyLonger) {
  RandomEngine engine(22);
  for (int trial = 0; trial < kSymmetricGrids; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const std::optional<DiscPath> path = solve(problem);
    if (!path) continue;
    const Path points = to_polyline(*path, problem.cells);
    EXPECT_EQ(points.front(), path->start);
    EXPECT_EQ(points.back(), path->goal);
    ASSERT_GE(length(points), path->length * (1 - 1e-9)) << "trial " << trial;
    ASSERT_LE(length(points), path->length * (1 + 1e-6)) << "trial " << trial;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const TPoint2D a = problem.cells.to_cells(points[i - 1]),
                     b = problem.cells.to_cells(points[i]);
      ASSERT_TRUE(is_far_from_occupied(problem.cells, a, b, problem.radius - kContact / kCellSize))
          << "trial " << trial << ", chord " << i;
    }
  }
}

TEST(DiscPathProperties, MirroredTurnedAndReversedProblemsHaveTheSameLength) {
  RandomEngine engine(23);
  for (int trial = 0; trial < kSymmetricGrids; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const double expected = length_of(solve(problem));
    for (int symmetry = 0; symmetry < 16; ++symmetry) {
      DiscProblem other = transformed(problem, symmetry & 7);
      if ((symmetry & 8) != 0) std::swap(other.start, other.goal);
      const double found = length_of(solve(other));
      ASSERT_EQ(std::isfinite(found), std::isfinite(expected)) << trial << ", " << symmetry;
      if (std::isfinite(expected)) {
        ASSERT_NEAR(found, expected, 1e-9 * expected) << trial << ", " << symmetry;
      }
    }
  }
}

}  // namespace
}  // namespace slalom
