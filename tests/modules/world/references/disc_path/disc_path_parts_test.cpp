// SPDX-License-Identifier: BSD-3-Clause
// The parts of the search for the shortest path of a disc, each against its definition.
#include "disc_path/connection.h"
#include "disc_path/disc_arcs.h"
#include "disc_path/open_rows.h"
#include "disc_problems.h"
#include "tangent_graph.h"

#include <slalom/references/disc_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace slalom::disc_path {
namespace {

constexpr int kTrials = 300;

TEST(CommonTangent, TouchesBothCirclesOnTheirSides) {
  RandomEngine engine(31);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto coordinate = [&] { return uniform_real(engine, 0, 10); };
    const Vector a(coordinate(), coordinate()), b(coordinate(), coordinate());
    const double ra = uniform_real(engine, -2, 2), rb = uniform_real(engine, -2, 2);
    const auto tangent = common_tangent(a, ra, b, rb);
    ASSERT_EQ(tangent.has_value(), norm(b - a) >= std::abs(rb - ra));
    if (!tangent) continue;
    // The center is at the signed radius left of the line.
    const Vector& d = tangent->direction;
    const Vector from = a - left(d) * ra, to = b - left(d) * rb;
    EXPECT_NEAR(norm(d), 1, 1e-12);
    EXPECT_NEAR(norm(to - from - d * tangent->length), 0, 1e-12);
  }
}

TEST(CommonTangent, OfCirclesThatOverlapByRoundingErrorsIsThatOfTouchingOnes) {
  const auto tangent = common_tangent({0, 0}, 2, {4 - 3e-8, 0}, -2);
  ASSERT_TRUE(tangent.has_value());
  EXPECT_EQ(tangent->length, 0);
  EXPECT_NEAR(tangent->direction.y, 1, 1e-12) << "between the circles, the first on the left";
  EXPECT_FALSE(common_tangent({0, 0}, 2, {4 - 1e-6, 0}, -2).has_value());
  EXPECT_FALSE(common_tangent({1, 1}, 2, {1, 1}, 2).has_value());
}

TEST(IsSweepFree, MeasuresTheDistanceToEverySquare) {
  RandomEngine engine(32);
  int free = 0;
  for (int trial = 0; trial < 10 * kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const OccupiedRows rows(problem.cells);
    const auto point = [&] {
      const Vector p(uniform_real(engine, -1, problem.cells.size_x() + 1),
                     uniform_real(engine, -1, problem.cells.size_y() + 1));
      return uniform_int(engine, 0, 1) == 0 ? p : Vector(std::round(p.x), std::round(p.y));
    };
    const Vector p = point(), q = uniform_int(engine, 0, 9) == 0 ? p : point();
    for (const double radius : {0.3, 1 - 1e-9, 1 + 1e-9, 1.7}) {
      const bool expected = is_far_from_occupied(problem.cells, p, q, radius);
      ASSERT_EQ(is_sweep_free(rows, p, q, radius), expected) << trial << ", " << radius;
      free += expected ? 1 : 0;
    }
  }
  EXPECT_GT(free, kTrials);
}

TEST(OpenRows, HoldEveryCellWithAFreePoint) {
  RandomEngine engine(33);
  for (int trial = 0; trial < kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const OccupiedRows occupied(problem.cells);
    const OpenRows open(occupied, problem.radius);
    for (int y = 0; y < problem.cells.size_y(); ++y)
      for (int x = 0; x < problem.cells.size_x(); ++x) {
        const Vector p(x + uniform_real(engine, 0, 1), y + uniform_real(engine, 0, 1));
        if (!is_sweep_free(occupied, p, p, problem.radius)) continue;
        const auto* run = open.find(x, y);  // testing::Test has a Run of its own
        ASSERT_NE(run, nullptr) << trial;
        ASSERT_TRUE(run->first <= x && x < run->last);
      }
  }
}

/// The cells that a chain of open cells, touching at sides or corners, joins to (x, y).
std::set<std::pair<int, int>> joined_cells(const OpenRows& open, int x, int y) {
  std::set<std::pair<int, int>> joined{{x, y}};
  std::vector<std::pair<int, int>> front{{x, y}};
  while (!front.empty()) {
    const auto [at_x, at_y] = front.back();
    front.pop_back();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (open.find(at_x + dx, at_y + dy) != nullptr &&
            joined.emplace(at_x + dx, at_y + dy).second)
          front.emplace_back(at_x + dx, at_y + dy);
  }
  return joined;
}

TEST(MayConnect, IsTrueIfAChainOfOpenCellsJoinsThePoints) {
  RandomEngine engine(35);
  int joined_pairs = 0, separate_pairs = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const OccupiedRows occupied(problem.cells);
    const OpenRows open(occupied, problem.radius);
    std::vector<std::pair<int, int>> cells;
    for (int y = 0; y < problem.cells.size_y(); ++y)
      for (int x = 0; x < problem.cells.size_x(); ++x)
        if (open.find(x, y) != nullptr) cells.emplace_back(x, y);
    if (cells.empty()) continue;
    for (int pair = 0; pair < 10; ++pair) {
      const auto cell = [&] {
        return cells[static_cast<std::size_t>(
            uniform_int(engine, 0, static_cast<int>(cells.size()) - 1))];
      };
      const auto from = cell(), to = cell();
      const bool expected = joined_cells(open, from.first, from.second).count(to) == 1;
      ASSERT_EQ(may_connect(open, {from.first + 0.5, from.second + 0.5},
                            {to.first + 0.5, to.second + 0.5}),
                expected)
          << trial;
      ++(expected ? joined_pairs : separate_pairs);
    }
  }
  EXPECT_GT(joined_pairs, kTrials);
  EXPECT_GT(separate_pairs, kTrials / 3);
}

TEST(MayConnect, NeverDeniesAPathThatExists) {
  RandomEngine engine(36);
  int denied = 0;
  for (int trial = 0; trial < 10 * kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const OccupiedRows occupied(problem.cells);
    const OpenRows open(occupied, problem.radius);
    if (may_connect(open, problem.start, problem.goal)) continue;
    ++denied;
    std::string reason;
    ASSERT_FALSE(shortest_disc_path(problem.cells, problem.radius * kCellSize,
                                    problem.start * kCellSize, problem.goal * kCellSize, reason))
        << trial;
  }
  EXPECT_GT(denied, 30);
}

TEST(OpenRows, AreExactNextToAWall) {
  // Columns 0 and 1 are closer than 2.4 to the wall everywhere, column 2 is not.
  const Occupancy cells(20, 20, kCellSize, {0, 0});
  const OccupiedRows occupied(cells);
  const OpenRows open(occupied, 2.4);
  ASSERT_EQ(open.runs(10).size(), 1U);
  EXPECT_EQ(open.runs(10)[0].first, 2);
  EXPECT_EQ(open.runs(10)[0].last, 18);
  EXPECT_TRUE(open.runs(1).empty());
  EXPECT_FALSE(open.runs(2).empty());
  EXPECT_TRUE(open.runs(-1).empty());
}

TEST(ArcRows, FindEveryPointOfEveryCornersArc) {
  RandomEngine engine(34);
  for (int trial = 0; trial < kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const Occupancy& cells = problem.cells;
    const OccupiedRows occupied(cells);
    ArcRows arcs(occupied, problem.radius);
    for (int y = 1; y < cells.size_y(); ++y)
      for (int x = 1; x < cells.size_x(); ++x) {
        const int around = cells.occupied(x - 1, y - 1) + cells.occupied(x, y - 1) +
                           cells.occupied(x - 1, y) + cells.occupied(x, y);
        if (around != 1) continue;
        const int out_x = cells.occupied(x - 1, y - 1) || cells.occupied(x - 1, y) ? 1 : -1;
        const int out_y = cells.occupied(x - 1, y - 1) || cells.occupied(x, y - 1) ? 1 : -1;
        const double angle = uniform_real(engine, 0, M_PI / 2);
        const Vector p(x + out_x * problem.radius * std::cos(angle),
                       y + out_y * problem.radius * std::sin(angle));
        const int row = static_cast<int>(std::floor(p.y));
        if (row < 0 || row >= cells.size_y()) continue;
        const auto [begin, end] = arcs.near(row, p.x, p.x);
        ASSERT_TRUE(std::any_of(begin, end, [&](int i) {
          return arcs[i].x == x && arcs[i].y == y && arcs[i].out_x == out_x &&
                 arcs[i].out_y == out_y;
        })) << trial;
      }
  }
}

TEST(ExposedParts, AreWhereTheDiscIsFree) {
  RandomEngine engine(35);
  int exposed = 0, covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const DiscProblem problem = random_problem(engine);
    const OccupiedRows occupied(problem.cells);
    ArcRows arcs(occupied, problem.radius);
    const double checked = problem.radius - kClearanceTolerance;
    const auto [begin, end] = arcs.near(problem.cells.size_y() / 2, 0, problem.cells.size_x());
    for (const int* i = begin; i != end; ++i) {
      const Arc& arc = arcs[*i];
      const std::vector<Interval> parts = exposed_parts(occupied, arc, problem.radius, checked);
      const double angle = uniform_real(engine, 0, M_PI / 2);
      const Vector p =
          arc.center() +
          Vector(arc.out_x * std::cos(angle), arc.out_y * std::sin(angle)) * problem.radius;
      const bool is_exposed = std::any_of(parts.begin(), parts.end(), [&](const Interval& part) {
        return angle >= part.first && angle <= part.second;
      });
      ASSERT_EQ(is_exposed, is_far_from_occupied(problem.cells, p, p, checked)) << trial;
      (is_exposed ? exposed : covered) += 1;
    }
  }
  EXPECT_GT(exposed, kTrials);
  EXPECT_GT(covered, kTrials / 3);
}

}  // namespace
}  // namespace slalom::disc_path
