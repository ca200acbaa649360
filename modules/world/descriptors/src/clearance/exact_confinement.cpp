// SPDX-License-Identifier: BSD-3-Clause
#include "confined_fraction.h"

#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// A straight boundary edge of the occupied cells (cells): all points (along, at) of a row border,
/// or (at, along) of a column border. Visible only from its free side.
struct Edge {
  double at, first, last;
  bool free_above;  ///< whether the free side has the larger coordinates
};

/// All edges between rows (or, transposed, columns); runs with the same free side are merged.
std::vector<Edge> edges_of(const Occupancy& cells, bool transposed) {
  const int lines = transposed ? cells.size_x() : cells.size_y();
  const int count = transposed ? cells.size_y() : cells.size_x();
  const auto occupied = [&](int line, int i) {
    return transposed ? cells.occupied(line, i) : cells.occupied(i, line);
  };
  std::vector<Edge> edges;
  for (int line = 0; line <= lines; ++line) {
    int side = 0;  // of the current run: 1 free above, -1 free below
    for (int i = 0; i < count; ++i) {
      const int here = (occupied(line - 1, i) ? 1 : 0) - (occupied(line, i) ? 1 : 0);
      if (here != 0 && here == side)
        edges.back().last = i + 1;
      else if (here != 0)
        edges.push_back({static_cast<double>(line), static_cast<double>(i), i + 1.0, here > 0});
      side = here;
    }
  }
  return edges;
}

/// Pseudo-angle of (x, y): increases with the angle from 0 to 4, without trigonometry.
double pseudo_angle(double x, double y) {
  const double fraction = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - fraction;
  return y < 0 ? 4 + fraction : fraction;
}

/// The angle (rad) of a pseudo-angle.
double angle_of(double pseudo) {
  const double y = pseudo < 1 ? pseudo : pseudo < 3 ? 2 - pseudo : pseudo - 4;
  const double x = (pseudo < 1 || pseudo > 3 ? 1 : -1) * (1 - std::abs(y));
  const double angle = math::atan2(y, x);
  return pseudo >= 2 && angle < 0 ? angle + 2 * M_PI : angle;
}

/// Arcs of directions, counter-clockwise, as intervals of pseudo-angles.
class Arcs {
 public:
  void clear() { arcs_.clear(); }

  void add(double from, double to) {
    if (from <= to) {
      arcs_.emplace_back(from, to);
    } else {
      arcs_.emplace_back(from, 4);
      arcs_.emplace_back(0, to);
    }
  }

  /// The total angle (rad) of the directions in no arc.
  double uncovered() {
    std::sort(arcs_.begin(), arcs_.end());
    double until = 0, gaps = 0;
    for (const auto& [from, to] : arcs_) {
      if (from > until) gaps += angle_of(from) - angle_of(until);
      until = std::max(until, to);
    }
    return gaps + (until < 4 ? 2 * M_PI - angle_of(until) : 0);
  }

 private:
  std::vector<std::pair<double, double>> arcs_;
};

/// The directions with an obstacle within range from a point. Occlusion is irrelevant: a direction
/// counts if any obstacle lies within the range.
class ArcsInRange {
 public:
  ArcsInRange(const Occupancy& cells, double range)
      : rows_(edges_of(cells, false)), columns_(edges_of(cells, true)), range_(range) {}

  double confined_fraction(double x, double y) {
    arcs_.clear();
    for (const Edge& edge : rows_) add(edge, x, y, false);
    for (const Edge& edge : columns_) add(edge, y, x, true);
    return 1 - arcs_.uncovered() / (2 * M_PI);
  }

 private:
  void add(const Edge& edge, double along, double across, bool transposed) {
    const double away = edge.at - across;
    if ((away < 0) != edge.free_above || std::abs(away) >= range_) return;
    const double half = std::sqrt(range_ * range_ - away * away);
    const double first = std::max(edge.first - along, -half);
    const double last = std::min(edge.last - along, half);
    if (first >= last) return;
    const double a = transposed ? pseudo_angle(away, first) : pseudo_angle(first, away);
    const double b = transposed ? pseudo_angle(away, last) : pseudo_angle(last, away);
    if ((away < 0) != transposed)  // below, or on the right: counter-clockwise from first to last
      arcs_.add(a, b);
    else
      arcs_.add(b, a);
  }

  std::vector<Edge> rows_, columns_;
  double range_;  ///< cells
  Arcs arcs_;
};

/// Gauss-Legendre nodes and weights on [0, 1] (Abramowitz and Stegun, table 25.4).
struct Node {
  double at, weight;
};
using Nodes = std::vector<Node>;

const Nodes kTwoNodes = {{0.5 - 0.28867513459481287, 0.5}, {0.5 + 0.28867513459481287, 0.5}};
const Nodes kFourNodes = {{0.5 - 0.43056815579702629, 0.17392742256872693},
                          {0.5 - 0.16999052179242813, 0.32607257743127307},
                          {0.5 + 0.16999052179242813, 0.32607257743127307},
                          {0.5 + 0.43056815579702629, 0.17392742256872693}};

/// Near an occupied cell the directions that it fills change within a cell.
bool is_near_occupied(const Occupancy& cells, int cx, int cy) {
  constexpr int kNear = 2;  // cells
  for (int y = cy - kNear; y <= cy + kNear; ++y)
    for (int x = cx - kNear; x <= cx + kNear; ++x)
      if (cells.occupied(x, y)) return true;
  return false;
}

/// Mean over one cell. The nodes depend on the cells alone, so that the mean never falls as the
/// range grows.
double mean_over_cell(ArcsInRange& around, int cx, int cy, const Nodes& nodes) {
  double mean = 0;
  for (const Node& y : nodes)
    for (const Node& x : nodes)
      mean += x.weight * y.weight * around.confined_fraction(cx + x.at, cy + y.at);
  return mean;
}

}  // namespace

double exact_confinement(const Occupancy& cells, double range) {
  ArcsInRange around(cells, range / cells.resolution());
  double sum = 0;
  std::size_t free_cells = 0;
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (cells.occupied(cx, cy)) continue;
      sum +=
          mean_over_cell(around, cx, cy, is_near_occupied(cells, cx, cy) ? kFourNodes : kTwoNodes);
      ++free_cells;
    }
  return free_cells == 0 ? 0 : sum / static_cast<double>(free_cells);
}

}  // namespace slalom
