// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "queue.h"
#include "search_space.h"

#include <limits>

namespace slalom::disc_path {

/// A circle that a path turns around, with the best path to a point of it. The path goes on at any
/// direction from `arrival` to `last_departure`. The start is a circle of radius 0.
struct Root {
  Vector center;
  double radius = 0;
  int turn = 0;           ///< +1 left, -1 right, 0 for the start
  Vector arrival;         ///< unit vector from the center to the point of arrival
  Vector last_departure;  ///< the same of the last point at which the path may leave
  Vector at;              ///< point of arrival
  Vector left_parent_at;  ///< where the segment to it leaves the previous circle
  double length = 0;      ///< of the path to it
  int parent = -1;
  int arc = -1;
  bool is_beaten = false;  ///< by another path to the same arc
};

/// The part of a row of cells that a root sees: a run of open cells, within a cone if there is one.
struct Window {
  int row = 0;
  Run run;
  bool has_limits = false;
  Line low, high;

  bool contains(const Vector& p) const;
};

/// The roots of a search with the best path found to the goal. Windows only select what may be
/// visible: each segment is checked exactly before it is used.
class Roots {
 public:
  Roots(SearchSpace& space, Queue& queue);

  const Root& operator[](int i) const { return roots_[static_cast<std::size_t>(i)]; }
  /// Length of the best path to the goal so far.
  double best_length() const { return best_length_; }
  /// Point at which that path leaves its last circle.
  const Vector& best_departure() const { return best_departure_; }

  /// Connects a root to the goal.
  void offer_goal(int root);
  /// Connects a root to the arcs that cross [low, high] of the window's row.
  void offer_arcs(int root, double low, double high, const Window& window);

 private:
  /// The best path to a position of an arc: alpha is the angle along its turn, base the length of
  /// the path less the part on the arc, so that of two labels the one with the smaller values is
  /// never longer.
  struct Label {
    double alpha = 0, base = 0;
    double exposed_from = 0;  ///< identifies the exposed part of the arc
    int root = 0;
    int next = -1;
  };
  struct Departure {
    Vector at;
    double length = 0;  ///< of the path until there
  };

  bool departs(const Root& from, const Vector& direction, Departure& departure) const;
  void offer(int root, int arc, int turn, const Window& window);
  const Interval* exposed_part(Arc& arc, double angle);
  bool is_dominated(int label, const Label& candidate) const;
  void mark_beaten(int label, const Label& better);

  SearchSpace& space_;
  Queue& queue_;
  std::vector<Root> roots_;
  std::vector<Label> labels_;
  double best_length_ = std::numeric_limits<double>::infinity();
  Vector best_departure_;
};

}  // namespace slalom::disc_path
