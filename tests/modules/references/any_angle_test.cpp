#include <slalom/core/random.h>
#include <slalom/references/any_angle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

CellGrid from_rows(const std::vector<std::string>& rows) {  // top row first
  CellGrid grid;
  grid.size_x = static_cast<int>(rows[0].size());
  grid.size_y = static_cast<int>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row) grid.blocked.push_back(c == '#' ? 1 : 0);
  return grid;
}

CellGrid random_grid(RandomEngine& engine, int size, double density) {
  CellGrid grid{size, size, {}};
  for (int i = 0; i < size * size; ++i)
    grid.blocked.push_back(uniform_real(engine, 0, 1) < density ? 1 : 0);
  return grid;
}

/// Whether the segment stays in the closed free cells without passing between two blocked cells
/// that touch at a corner, decided piece by piece between all crossings with grid lines: an
/// independent slow test.
bool is_visible(const CellGrid& grid, const TPoint2D& a, const TPoint2D& b) {
  std::vector<double> cuts = {0, 1};
  const auto add_cuts = [&cuts](double from, double to, int size) {
    for (int line = 0; line <= size; ++line)
      if (to != from) cuts.push_back((line - from) / (to - from));
  };
  add_cuts(a.x, b.x, grid.size_x);
  add_cuts(a.y, b.y, grid.size_y);
  std::sort(cuts.begin(), cuts.end());
  const auto at = [&](double t) { return TPoint2D(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t); };
  constexpr double kNear = 1e-7;
  const auto free_on_side = [&](const TPoint2D& p, double nudge_x, double nudge_y) {
    return !grid.is_blocked(static_cast<int>(std::floor(p.x + nudge_x)),
                            static_cast<int>(std::floor(p.y + nudge_y)));
  };
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i - 1] < 0 || cuts[i] > 1 || cuts[i] - cuts[i - 1] < 1e-12) continue;
    const TPoint2D middle = at(0.5 * (cuts[i - 1] + cuts[i]));
    bool free = false;
    for (const double nx : {-kNear, kNear})
      for (const double ny : {-kNear, kNear}) free = free || free_on_side(middle, nx, ny);
    if (!free) return false;
  }
  for (const double t : cuts) {  // vertices inside the segment
    if (t <= 1e-9 || t >= 1 - 1e-9) continue;
    const TPoint2D p = at(t);
    const double x = std::round(p.x), y = std::round(p.y);
    if (std::hypot(p.x - x, p.y - y) > 1e-9) continue;
    const int vx = static_cast<int>(x), vy = static_cast<int>(y);
    const bool sw = grid.is_blocked(vx - 1, vy - 1), ne = grid.is_blocked(vx, vy);
    const bool nw = grid.is_blocked(vx - 1, vy), se = grid.is_blocked(vx, vy - 1);
    if ((sw && ne && !nw && !se) || (nw && se && !sw && !ne)) return false;
  }
  return true;
}

/// Dijkstra over start, goal and every convex corner, all pairs tested for visibility.
double brute_force_length(const CellGrid& grid, const TPoint2D& start, const TPoint2D& goal) {
  std::vector<TPoint2D> points = {start, goal};
  for (int y = 1; y < grid.size_y; ++y)
    for (int x = 1; x < grid.size_x; ++x) {
      const int blocked = grid.is_blocked(x - 1, y - 1) + grid.is_blocked(x, y - 1) +
                          grid.is_blocked(x - 1, y) + grid.is_blocked(x, y);
      if (blocked == 1) points.emplace_back(x, y);
    }
  std::vector<double> best(points.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(points.size(), false);
  best[0] = 0;
  while (true) {
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!done[i] && std::isfinite(best[i]) && (next == points.size() || best[i] < best[next]))
        next = i;
    if (next == points.size() || next == 1) return best[1];
    done[next] = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double total =
          best[next] + std::hypot(points[i].x - points[next].x, points[i].y - points[next].y);
      if (!done[i] && total < best[i] && is_visible(grid, points[next], points[i])) best[i] = total;
    }
  }
}

void expect_as_brute_force(const CellGrid& grid, const TPoint2D& start, const TPoint2D& goal) {
  const double expected = brute_force_length(grid, start, goal);
  const auto path = shortest_any_angle_path(grid, start, goal);
  ASSERT_EQ(path.has_value(), std::isfinite(expected));
  if (!path) return;
  EXPECT_NEAR(length(*path), expected, 1e-9 * expected);
  EXPECT_EQ(path->front(), start);
  EXPECT_EQ(path->back(), goal);
  for (std::size_t i = 1; i < path->size(); ++i)
    EXPECT_TRUE(is_visible(grid, (*path)[i - 1], (*path)[i]));
}

TEST(AnyAngle, IsTheStraightLineWithoutObstacles) {
  const CellGrid grid = from_rows({"....", "....", "...."});
  const auto path = shortest_any_angle_path(grid, {0.3, 0.2}, {3.7, 2.9});
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->size(), 2U);
}

TEST(AnyAngle, GoesAroundABlockAtItsCorner) {
  const CellGrid grid = from_rows({".....", "..#..", "....."});
  // From (0, 1.5) over the corners (2, 2), (3, 2): 2 * |(2, 0.5)| + 1.
  const auto path = shortest_any_angle_path(grid, {0, 1.5}, {5, 1.5});
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(length(*path), 2 * std::hypot(2, 0.5) + 1, 1e-12);
}

TEST(AnyAngle, DoesNotPassBetweenCellsThatTouchAtACorner) {
  EXPECT_FALSE(shortest_any_angle_path(from_rows({".#", "#."}), {0.5, 1.5}, {1.5, 0.5}));
  const CellGrid grid = from_rows({"...", ".#.", "#.."});
  expect_as_brute_force(grid, {0.5, 1.5}, {1.5, 0.5});
}

TEST(AnyAngle, HasNoPathFromOrToBlockedCells) {
  const CellGrid grid = from_rows({"..#", "..#"});
  EXPECT_FALSE(shortest_any_angle_path(grid, {0.5, 0.5}, {2.5, 0.5}));
  EXPECT_FALSE(shortest_any_angle_path(grid, {-1, 0.5}, {0.5, 0.5}));
}

TEST(AnyAngle, AgreesWithBruteForceFromRandomPoints) {
  RandomEngine engine(11);
  for (int trial = 0; trial < 1500; ++trial) {
    const int size = uniform_int(engine, 2, 9);
    const CellGrid grid = random_grid(engine, size, uniform_real(engine, 0, 0.5));
    const auto coordinate = [&] { return uniform_real(engine, 0, size); };
    const TPoint2D start(coordinate(), coordinate()), goal(coordinate(), coordinate());
    const auto blocked = [&](const TPoint2D& p) {
      return grid.is_blocked(static_cast<int>(p.x), static_cast<int>(p.y));
    };
    if (!blocked(start) && !blocked(goal)) expect_as_brute_force(grid, start, goal);
    if (HasFailure()) FAIL() << "trial " << trial;
  }
}

TEST(AnyAngle, AgreesWithBruteForceFromVerticesAndBorders) {
  RandomEngine engine(12);
  int compared = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const int size = uniform_int(engine, 2, 8);
    const CellGrid grid = random_grid(engine, size, uniform_real(engine, 0, 0.45));
    const auto coordinate = [&] { return 0.5 * uniform_int(engine, 0, 2 * size); };
    const TPoint2D start(coordinate(), coordinate()), goal(coordinate(), coordinate());
    const auto touches_free = [&](const TPoint2D& p) {
      return !grid.is_blocked(static_cast<int>(std::floor(p.x)),
                              static_cast<int>(std::floor(p.y))) ||
             !grid.is_blocked(static_cast<int>(std::ceil(p.x)) - 1,
                              static_cast<int>(std::ceil(p.y)) - 1);
    };
    if (start == goal || !touches_free(start) || !touches_free(goal)) continue;
    ++compared;
    expect_as_brute_force(grid, start, goal);
    if (HasFailure()) FAIL() << "trial " << trial;
  }
  EXPECT_GT(compared, 500);
}

TEST(AnyAngle, AgreesWithBruteForceOnLargerGrids) {
  RandomEngine engine(13);
  int compared = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const CellGrid grid = random_grid(engine, 30, uniform_real(engine, 0.05, 0.35));
    if (grid.is_blocked(1, 1) || grid.is_blocked(28, 27)) continue;
    expect_as_brute_force(grid, {1.5, 1.25}, {28.5, 27.75});
    ++compared;
  }
  EXPECT_GT(compared, 4);  // expected: at least 12 * 0.65^2 = 5.07
}

}  // namespace
}  // namespace slalom
