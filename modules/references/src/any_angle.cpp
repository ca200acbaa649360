#include "cell_rows.h"

#include <slalom/core/distance.h>
#include <slalom/references/any_angle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Tolerance (cells) of positions: intervals are closed, corners at their ends are included.
constexpr double kEps = 1e-9;

double cross(const TPoint2D& a, const TPoint2D& b) {
  return a.x * b.y - a.y * b.x;
}

/// A point at which a path may turn, with the best path to it.
struct Root {
  TPoint2D at;
  double g = 0;       ///< length of the path to it
  int parent = -1;    ///< index of the previous root
  TPoint2D incoming;  ///< direction from the parent; (0, 0) for the start
  int turn = 0;       ///< +1: may only turn left (obstacle on the left), -1: right, 0: both
  std::size_t corner = 0;
};

/// The cone visible from a root through an interval on the line y = row, upwards (dir +1) or
/// downwards (-1).
struct Cone {
  int root = 0;
  int row = 0;
  int dir = 0;
  TPoint2D low, high;  ///< points on the limiting rays
};

/// In the order in which items of equal f are expanded.
enum class Kind { Goal, Root, Cone };

struct Item {
  double f = 0;
  Kind kind = Kind::Goal;
  int index = 0;
  bool operator<(const Item& other) const {  // for a max-heap: the smallest f first
    return std::tie(f, kind, index) > std::tie(other.f, other.kind, other.index);
  }
};

/// The x at which the ray from `origin` through `via` intersects the line y = row.
double at_row(const TPoint2D& origin, const TPoint2D& via, double row) {
  return origin.x + (via.x - origin.x) * ((row - origin.y) / (via.y - origin.y));
}

/// Length of the shortest path from a via [low, high] on the line y = row to b: a lower bound for
/// all paths through that interval.
double length_through(const TPoint2D& a, TPoint2D b, double row, double low, double high) {
  if ((a.y < row) == (b.y < row)) b.y = 2 * row - b.y;  // reflected: the path must touch the line
  const double span = b.y - a.y;
  const double straight = span != 0 ? a.x + (b.x - a.x) * ((row - a.y) / span) : b.x;
  const TPoint2D via(std::clamp(straight, low, std::max(low, high)), row);
  return distance_between(a, via) + distance_between(via, b);
}

/// Best-first search over roots and their visible intervals, as in Anya (Harabor et al. 2016):
/// intervals are propagated row by row, so that only those on possible shortest paths are expanded.
class AnyAngleSearch {
 public:
  AnyAngleSearch(const CellGrid& grid, const TPoint2D& start, const TPoint2D& goal)
      : rows_(grid),
        goal_(goal),
        best_g_(rows_.corners().size(), std::numeric_limits<double>::infinity()) {
    roots_.push_back({start, 0, -1, {0, 0}, 0, kNoCorner});
  }

  std::optional<Path> run() {
    expand_root(0);
    while (!queue_.empty()) {
      const Item item = queue_.top();
      queue_.pop();
      if (item.kind == Kind::Goal) return path_to(item.index);
      if (item.kind == Kind::Root) {
        if (is_current(item.index)) expand_root(item.index);
      } else {
        const Cone cone = cones_[static_cast<std::size_t>(item.index)];
        free_cones_.push_back(item.index);
        if (is_current(cone.root)) advance(cone);
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kNoCorner = std::numeric_limits<std::size_t>::max();

  const Root& root(int i) const { return roots_[static_cast<std::size_t>(i)]; }

  /// Whether no shorter path to the root's corner was found since.
  bool is_current(int i) const {
    return root(i).corner == kNoCorner || best_g_[root(i).corner] >= root(i).g;
  }

  Path path_to(int last) const {
    Path path = {goal_};
    for (int i = last; i >= 0; i = root(i).parent) path.push_back(root(i).at);
    std::reverse(path.begin(), path.end());
    return path;
  }

  void reach_goal(int from) {
    queue_.push({root(from).g + distance_between(root(from).at, goal_), Kind::Goal, from});
  }

  /// Expands all directions that a taut path through the root may take.
  void expand_root(int i) {
    const TPoint2D at = root(i).at;
    if (at.x == goal_.x && at.y == goal_.y) reach_goal(i);
    const int below = static_cast<int>(std::ceil(at.y)) - 1;  // row of cells under the point
    if (at.y == std::floor(at.y)) {
      const int line = static_cast<int>(at.y);
      scan_line(i, line, -1);
      scan_line(i, line, +1);
      scan_row(i, line, +1);
      scan_row(i, line - 1, -1);
    } else {
      scan_row(i, below, +1);
      scan_row(i, below, -1);
    }
  }

  /// The complete runs of cell row cy that touch the root: all of a convex run is visible.
  void scan_row(int i, int cy, int dir) {
    if (cy < 0 || cy >= rows_.size_y()) return;
    const double x = root(i).at.x;
    const int right = static_cast<int>(std::floor(x));
    const int left = static_cast<int>(std::ceil(x)) - 1;
    if (!rows_.is_blocked(right, cy)) project_run(i, cy, dir, rows_.run(right, cy));
    // On a border between cells the left one may be another run, or the only free one.
    if (left != right && !rows_.is_blocked(left, cy) && rows_.is_blocked(right, cy))
      project_run(i, cy, dir, rows_.run(left, cy));
  }

  void project_run(int i, int cy, int dir, const FreeRun& run) {
    if (goal_.y >= cy && goal_.y <= cy + 1 && goal_.x >= run.first && goal_.x <= run.last)
      reach_goal(i);
    const int far = dir > 0 ? cy + 1 : cy;
    double low = run.first, high = run.last;
    if (!clip_to_turn(root(i), far, low, high)) return;
    const auto y = static_cast<double>(far);
    push_cone({i, far, dir, {low, y}, {high, y}}, low, high);
  }

  /// Clips [low, high] on line `row` to the part reachable by a path that keeps turning around the
  /// obstacle.
  static bool clip_to_turn(const Root& from, int row, double& low, double& high) {
    if (from.turn == 0) return true;
    const TPoint2D& d = from.incoming;
    const double rise = row - from.at.y;
    if (d.y == 0) return from.turn * d.x * rise >= 0;
    // turn * (d.x * rise - d.y * t) >= 0 for the point at (t, rise) from the root
    const double limit = from.at.x + d.x * rise / d.y;
    if (from.turn * d.y > 0) {
      high = std::min(high, limit);
    } else {
      low = std::max(low, limit);
    }
    return high >= low - kEps;
  }

  /// Corners on the line through the root: visible if free cells lie along the complete segment.
  void scan_line(int i, int line, int dir) {
    if (!may_continue_along(root(i), dir)) return;
    const double x0 = root(i).at.x;
    int x = static_cast<int>(dir > 0 ? std::floor(x0) : std::ceil(x0));
    bool above = true, below = true;  // whether free cells lie along the segment behind x
    while (true) {
      const int segment = dir > 0 ? x : x - 1;
      // There is no passage between two blocked cells that touch at the vertex.
      above = above && !rows_.is_blocked(segment, line);
      below = below && !rows_.is_blocked(segment, line - 1);
      if (!above && !below) return;
      x += dir;
      if (goal_.y == line && (goal_.x - x0) * dir >= 0 && (x - goal_.x) * dir >= 0)
        return reach_goal(i);
      const auto [begin, end] = rows_.corners_between(line, x, x);
      if (begin != end) offer_corner(i, begin);
      above = !rows_.is_blocked(segment, line);
      below = !rows_.is_blocked(segment, line - 1);
    }
  }

  static bool may_continue_along(const Root& from, int dir) {
    return from.turn * cross(from.incoming, TPoint2D(dir, 0)) >= 0;
  }

  /// Adds the corners in the interval of the cone as roots, and the cone to the queue.
  void push_cone(const Cone& cone, double low, double high) {
    const auto [begin, end] = rows_.corners_between(cone.row, low - kEps, high + kEps);
    for (std::size_t corner = begin; corner != end; ++corner) offer_corner(cone.root, corner);
    if (high - low < kEps) return;
    const Root& from = root(cone.root);
    const double f = from.g + length_through(from.at, goal_, cone.row, low, high);
    int index = static_cast<int>(cones_.size());
    if (free_cones_.empty()) {
      cones_.push_back(cone);
    } else {
      index = free_cones_.back();
      free_cones_.pop_back();
      cones_[static_cast<std::size_t>(index)] = cone;
    }
    queue_.push({f, Kind::Cone, index});
  }

  /// Propagates a cone through the next row of cells.
  void advance(const Cone& cone) {
    const TPoint2D origin = root(cone.root).at;
    const double low = at_row(origin, cone.low, cone.row);
    const double high = at_row(origin, cone.high, cone.row);
    const int cy = cone.dir > 0 ? cone.row : cone.row - 1;
    rows_.for_runs(cy, low, high, [&](const FreeRun& run) { enter_run(cone, cy, run, low, high); });
  }

  void enter_run(const Cone& cone, int cy, const FreeRun& run, double low, double high) {
    const TPoint2D origin = root(cone.root).at;
    const int far = cone.row + cone.dir;
    Cone next = {cone.root, far, cone.dir, cone.low, cone.high};
    if (run.first > low) next.low = TPoint2D(run.first, cone.row);
    if (run.last < high) next.high = TPoint2D(run.last, cone.row);
    if (goal_.y >= cy && goal_.y <= cy + 1) test_goal(next, run);
    double far_low = at_row(origin, next.low, far), far_high = at_row(origin, next.high, far);
    if (far_low < run.first) {
      far_low = run.first;
      next.low = TPoint2D(far_low, far);
    }
    if (far_high > run.last) {
      far_high = run.last;
      next.high = TPoint2D(far_high, far);
    }
    if (far_high >= far_low - kEps) push_cone(next, far_low, std::max(far_low, far_high));
  }

  void test_goal(const Cone& cone, const FreeRun& run) {
    const TPoint2D origin = root(cone.root).at;
    if (goal_.x < run.first || goal_.x > run.last) return;
    if (goal_.x >= at_row(origin, cone.low, goal_.y) - kEps &&
        goal_.x <= at_row(origin, cone.high, goal_.y) + kEps)
      reach_goal(cone.root);
  }

  /// Adds a visible corner as root if a taut path can turn there and this is the shortest path to
  /// it so far.
  void offer_corner(int from, std::size_t corner) {
    const Corner& c = rows_.corners()[corner];
    const TPoint2D at(c.x, c.y);
    const TPoint2D d = at - root(from).at;
    // The blocked cell must lie completely on one side of the ray: both its edges at the corner do.
    const double first = cross(d, TPoint2D(c.side_x, 0)), second = cross(d, TPoint2D(0, c.side_y));
    if (first * second < 0 || (first == 0 && second == 0)) return;
    const double g = root(from).g + std::hypot(d.x, d.y);
    if (g >= best_g_[corner]) return;
    best_g_[corner] = g;
    roots_.push_back({at, g, from, d, first + second > 0 ? 1 : -1, corner});
    queue_.push({g + distance_between(at, goal_), Kind::Root, static_cast<int>(roots_.size()) - 1});
  }

  CellRows rows_;
  TPoint2D goal_;
  std::vector<double> best_g_;
  std::vector<Root> roots_;
  std::vector<Cone> cones_;
  std::vector<int> free_cones_;
  std::priority_queue<Item> queue_;
};

bool is_on_free_cell(const CellGrid& grid, const TPoint2D& p) {
  for (const int cx : {static_cast<int>(std::floor(p.x)), static_cast<int>(std::ceil(p.x)) - 1})
    for (const int cy : {static_cast<int>(std::floor(p.y)), static_cast<int>(std::ceil(p.y)) - 1})
      if (!grid.is_blocked(cx, cy)) return true;
  return false;
}

}  // namespace

std::optional<Path> shortest_any_angle_path(const CellGrid& grid, const TPoint2D& start,
                                            const TPoint2D& goal) {
  if (!is_on_free_cell(grid, start) || !is_on_free_cell(grid, goal)) return std::nullopt;
  return AnyAngleSearch(grid, start, goal).run();
}

}  // namespace slalom
