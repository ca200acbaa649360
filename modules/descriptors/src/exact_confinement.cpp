#include "confined_share.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// A straight piece of the outline of what is occupied (cells): all points (along, at) of a row
/// border, or (at, along) of a column border. Seen only from its free side.
struct Edge {
  double at, first, last;
  bool free_above;  ///< the free side is where coordinates are larger
};

/// All borders between rows (or, transposed, columns), runs with the same free side as one.
std::vector<Edge> edges_of(const Occupancy& cells, bool transposed) {
  const int lines = transposed ? cells.size_x() : cells.size_y();
  const int count = transposed ? cells.size_y() : cells.size_x();
  const auto occupied = [&](int line, int i) {
    return transposed ? cells.occupied(line, i) : cells.occupied(i, line);
  };
  std::vector<Edge> edges;
  for (int line = 0; line <= lines; ++line) {
    int side = 0;  // of the run that is open: 1 free above, -1 free below
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

/// Grows with the angle of (x, y) from 0 to 4 round the circle, without trigonometry.
double turn_of(double x, double y) {
  const double share = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - share;
  return y < 0 ? 4 + share : share;
}

/// The angle (rad) that belongs to such a number.
double angle_of(double turn) {
  const double y = turn < 1 ? turn : turn < 3 ? 2 - turn : turn - 4;
  const double x = (turn < 1 || turn > 3 ? 1 : -1) * (1 - std::abs(y));
  const double angle = std::atan2(y, x);
  return turn >= 2 && angle < 0 ? angle + 6.283185307179586476925 : angle;
}

/// Arcs of directions, counter-clockwise, as numbers of turn_of().
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

  /// The angle (rad) of all directions that are in no arc.
  double uncovered() {
    std::sort(arcs_.begin(), arcs_.end());
    double until = 0, gaps = 0;
    for (const auto& [from, to] : arcs_) {
      if (from > until) gaps += angle_of(from) - angle_of(until);
      until = std::max(until, to);
    }
    return gaps + (until < 4 ? 6.283185307179586476925 - angle_of(until) : 0);
  }

 private:
  std::vector<std::pair<double, double>> arcs_;
};

/// Looks round from one place. Occlusion does not matter: a direction counts as soon as anything
/// lies that way within the range.
class ArcsInRange {
 public:
  ArcsInRange(const Occupancy& cells, double range)
      : rows_(edges_of(cells, false)), columns_(edges_of(cells, true)), range_(range) {}

  double confined_share(double x, double y) {
    arcs_.clear();
    for (const Edge& edge : rows_) add(edge, x, y, false);
    for (const Edge& edge : columns_) add(edge, y, x, true);
    return 1 - arcs_.uncovered() / 6.283185307179586476925;
  }

 private:
  void add(const Edge& edge, double along, double across, bool transposed) {
    const double away = edge.at - across;
    if ((away < 0) != edge.free_above || std::abs(away) >= range_) return;
    const double half = std::sqrt(range_ * range_ - away * away);
    const double first = std::max(edge.first - along, -half);
    const double last = std::min(edge.last - along, half);
    if (first >= last) return;
    const double a = transposed ? turn_of(away, first) : turn_of(first, away);
    const double b = transposed ? turn_of(away, last) : turn_of(last, away);
    if ((away < 0) != transposed)  // seen below, or on the right: from first to last is left about
      arcs_.add(a, b);
    else
      arcs_.add(b, a);
  }

  std::vector<Edge> rows_, columns_;
  double range_;  ///< cells
  Arcs arcs_;
};

}  // namespace

double exact_confinement(const Occupancy& cells, double range) {
  ArcsInRange around(cells, range / cells.resolution());
  double sum = 0;
  std::size_t places = 0;
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (cells.occupied(cx, cy)) continue;
      sum += around.confined_share(cx + 0.5, cy + 0.5);
      ++places;
    }
  return places == 0 ? 0 : sum / static_cast<double>(places);
}

}  // namespace slalom
