// SPDX-License-Identifier: BSD-3-Clause
#include "tangent_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-11;  // of clearances, cells

double distance_to_point(const TPoint2D& a, const TPoint2D& b, const TPoint2D& p) {
  const TPoint2D w = b - a;
  const double square = w.x * w.x + w.y * w.y;
  const double t =
      square > 0 ? std::clamp(((p.x - a.x) * w.x + (p.y - a.y) * w.y) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * w.x, p.y - a.y - t * w.y);
}

/// Liang and Barsky's clipping at the closed square.
bool crosses_square(const TPoint2D& a, const TPoint2D& b, int cx, int cy) {
  const double step[4] = {a.x - b.x, b.x - a.x, a.y - b.y, b.y - a.y};
  const double space[4] = {a.x - cx, cx + 1 - a.x, a.y - cy, cy + 1 - a.y};
  double first = 0, last = 1;
  for (int i = 0; i < 4; ++i) {
    if (step[i] == 0) {
      if (space[i] < 0) return false;
    } else if (step[i] < 0) {
      first = std::max(first, space[i] / step[i]);
    } else {
      last = std::min(last, space[i] / step[i]);
    }
  }
  return first <= last;
}

double point_to_square(const TPoint2D& p, int cx, int cy) {
  return std::hypot(std::max({cx - p.x, 0.0, p.x - cx - 1}),
                    std::max({cy - p.y, 0.0, p.y - cy - 1}));
}

double distance_to_square(const TPoint2D& a, const TPoint2D& b, int cx, int cy) {
  if (crosses_square(a, b, cx, cy)) return 0;
  double least = std::min(point_to_square(a, cx, cy), point_to_square(b, cx, cy));
  for (const int x : {cx, cx + 1})
    for (const int y : {cy, cy + 1})
      least = std::min(least, distance_to_point(a, b, TPoint2D(x, y)));
  return least;
}

struct Corner {
  TPoint2D at;
  double middle = 0;  ///< direction away from its occupied cell, rad
};

/// A point of a circle at which a tangent begins or ends; `angle` grows along the turn.
struct Contact {
  double angle = 0;
  std::size_t node = 0;
};

class TangentGraph {
 public:
  TangentGraph(const Occupancy& cells, double radius) : cells_(cells), radius_(radius) {
    for (int y = 1; y < cells.size_y(); ++y)
      for (int x = 1; x < cells.size_x(); ++x) add_corner(x, y);
  }

  double shortest(const TPoint2D& start, const TPoint2D& goal) {
    if (!is_free(start, start) || !is_free(goal, goal)) return kInfinity;
    edges_.resize(2);
    connect({start, 0}, kStart, {goal, 0}, kGoal);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (const int turn : {-1, 1}) {
        connect({start, 0}, kStart, {corners_[i].at, turn}, i);
        connect({corners_[i].at, turn}, i, {goal, 0}, kGoal);
        for (std::size_t j = 0; j < i; ++j)
          for (const int next : {-1, 1})
            connect({corners_[i].at, turn}, i, {corners_[j].at, next}, j);
      }
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (const int turn : {-1, 1}) connect_along(i, turn);
    return dijkstra();
  }

 private:
  static constexpr std::size_t kStart = 0, kGoal = 1;  // nodes; the rest are contacts

  struct Circle {
    TPoint2D center;
    int turn = 0;  ///< 0: a point
  };
  struct Edge {
    std::size_t to = 0;
    double length = 0;
  };

  void add_corner(int x, int y) {
    const bool sw = cells_.occupied(x - 1, y - 1), se = cells_.occupied(x, y - 1);
    const bool nw = cells_.occupied(x - 1, y), ne = cells_.occupied(x, y);
    if (sw + se + nw + ne != 1) return;
    corners_.push_back({TPoint2D(x, y), std::atan2(sw || se ? 1 : -1, sw || nw ? 1 : -1)});
    contacts_.resize(2 * corners_.size());
  }

  bool is_free(const TPoint2D& a, const TPoint2D& b) const {
    return is_far_from_occupied(cells_, a, b, radius_ - kTolerance);
  }

  std::vector<Contact>& contacts(std::size_t corner, int turn) {
    return contacts_[2 * corner + (turn > 0 ? 1 : 0)];
  }

  /// The tangent from one circle to another, and back with opposite turns: the line between the
  /// centers, rotated so that it is at the difference of the signed radii from both.
  void connect(const Circle& a, std::size_t from, const Circle& b, std::size_t to) {
    constexpr double kSlack = 1e-9;
    const TPoint2D w = b.center - a.center;
    const double distance = w.norm(), offset = (b.turn - a.turn) * radius_;
    if (distance == 0 || distance < std::abs(offset) - kSlack) return;
    const double heading =
        std::atan2(w.y, w.x) - std::asin(std::clamp(offset / distance, -1.0, 1.0));
    const auto contact = [&](const Circle& circle) {  // as seen from the center
      return heading - circle.turn * M_PI / 2;
    };
    const auto point = [&](const Circle& circle) {
      if (circle.turn == 0) return circle.center;
      const double angle = contact(circle);
      return circle.center + TPoint2D(std::cos(angle), std::sin(angle)) * radius_;
    };
    const auto faces_away = [&](const Circle& circle, std::size_t corner) {
      return circle.turn == 0 || std::abs(std::remainder(contact(circle) - corners_[corner].middle,
                                                         2 * M_PI)) < M_PI / 4 + kSlack;
    };
    if (!faces_away(a, from) || !faces_away(b, to)) return;
    if (!is_free(point(a), point(b))) return;
    const double length = (point(b) - point(a)).norm();
    const auto node = [&](const Circle& circle, std::size_t on, int turn) {
      return circle.turn == 0 ? on : node_on(on, turn, contact(circle));
    };
    const std::size_t first = node(a, from, a.turn), last = node(b, to, b.turn);
    edges_[first].push_back({last, length});
    if (a.turn == 0 || b.turn == 0) return;
    const std::size_t back = node(b, to, -b.turn), end = node(a, from, -a.turn);  // reversed
    edges_[back].push_back({end, length});
  }

  std::size_t node_on(std::size_t corner, int turn, double angle) {
    edges_.emplace_back();
    contacts(corner, turn)
        .push_back(
            {turn * std::remainder(angle - corners_[corner].middle, 2 * M_PI), edges_.size() - 1});
    return edges_.size() - 1;
  }

  /// Arcs between neighboring contacts; contacts that differ by rounding errors are the same.
  void connect_along(std::size_t corner, int turn) {
    constexpr double kSame = 1e-8;
    std::vector<Contact>& on = contacts(corner, turn);
    std::sort(on.begin(), on.end(),
              [](const Contact& a, const Contact& b) { return a.angle < b.angle; });
    for (std::size_t i = 1; i < on.size(); ++i) {
      const Contact &a = on[i - 1], &b = on[i];
      const double sweep = b.angle - a.angle;
      const double middle = corners_[corner].middle;
      if (sweep >= kSame &&
          !is_arc_free(corners_[corner].at, middle + turn * a.angle, middle + turn * b.angle))
        continue;
      edges_[a.node].push_back({b.node, sweep * radius_});
      if (sweep < kSame) edges_[b.node].push_back({a.node, 0});
    }
  }

  /// The minimum of the distance to each square along the arc, by ternary search in parts of it.
  bool is_arc_free(const TPoint2D& center, double first, double last) const {
    const int reach = static_cast<int>(std::ceil(2 * radius_));
    const int cx = static_cast<int>(center.x), cy = static_cast<int>(center.y);
    for (int y = cy - reach - 1; y <= cy + reach; ++y)
      for (int x = cx - reach - 1; x <= cx + reach; ++x)
        if (cells_.occupied(x, y) && point_to_square(center, x, y) < 2 * radius_ &&
            !is_arc_free_of(x, y, center, first, last))
          return false;
    return true;
  }

  bool is_arc_free_of(int x, int y, const TPoint2D& center, double first, double last) const {
    constexpr int kParts = 12, kSteps = 40;
    const auto clearance = [&](double angle) {
      return point_to_square(center + TPoint2D(std::cos(angle), std::sin(angle)) * radius_, x, y);
    };
    for (int i = 0; i < kParts; ++i) {
      double low = first + (last - first) * i / kParts;
      double high = first + (last - first) * (i + 1) / kParts;
      const double ends = std::min(clearance(low), clearance(high));
      if (ends < radius_ - kTolerance) return false;
      if (ends > radius_ + std::abs(high - low) * radius_) continue;
      for (int step = 0; step < kSteps; ++step) {
        const double third = (high - low) / 3;
        if (clearance(low + third) < clearance(high - third))
          high -= third;
        else
          low += third;
      }
      if (clearance(0.5 * (low + high)) < radius_ - kTolerance) return false;
    }
    return true;
  }

  double dijkstra() const {
    std::vector<double> best(edges_.size(), kInfinity);
    std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                        std::greater<>>
        queue;
    queue.emplace(best[kStart] = 0, kStart);
    while (!queue.empty()) {
      const auto [so_far, at] = queue.top();
      queue.pop();
      if (at == kGoal) return so_far;
      if (so_far > best[at]) continue;
      for (const Edge& edge : edges_[at])
        if (so_far + edge.length < best[edge.to])
          queue.emplace(best[edge.to] = so_far + edge.length, edge.to);
    }
    return kInfinity;
  }

  const Occupancy& cells_;
  double radius_;
  std::vector<Corner> corners_;
  std::vector<std::vector<Contact>> contacts_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace

bool is_far_from_occupied(const Occupancy& cells, const TPoint2D& a, const TPoint2D& b,
                          double radius) {
  const auto first = [radius](double p, double q) {
    return static_cast<int>(std::floor(std::min(p, q) - radius)) - 1;
  };
  const auto last = [radius](double p, double q) {
    return static_cast<int>(std::ceil(std::max(p, q) + radius));
  };
  for (int y = first(a.y, b.y); y <= last(a.y, b.y); ++y)
    for (int x = first(a.x, b.x); x <= last(a.x, b.x); ++x)
      if (cells.occupied(x, y) && distance_to_square(a, b, x, y) < radius) return false;
  return true;
}

double tangent_graph_length(const Occupancy& cells, double radius, const TPoint2D& start,
                            const TPoint2D& goal) {
  return TangentGraph(cells, radius).shortest(start, goal);
}

}  // namespace slalom
