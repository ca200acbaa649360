// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "roots.h"

namespace slalom::disc_path {

/// Propagates what roots see through the rows of open cells, and offers them all arcs and the goal
/// there.
class ConeExpansion {
 public:
  ConeExpansion(SearchSpace& space, Roots& roots, Queue& queue)
      : space_(space), roots_(roots), queue_(queue) {}

  /// All directions from the start.
  void expand_start();
  /// All directions in which a path may leave the arc of a root.
  void expand_arc(int root);
  /// Through the next rows. Cones of lengths near the first in the queue are expanded as well.
  void expand(const Cone& cone);

 private:
  /// Limiting rays of a part of an arc, and where they meet the next line; infinite if they do not.
  struct Limits {
    Line low, high;
    double low_x = -std::numeric_limits<double>::infinity();
    double high_x = std::numeric_limits<double>::infinity();
  };

  void expand_piece(int root, const Vector& from, const Vector& to, int row, int direction);
  Limits limits_of(const Root& root, const Vector& from, const Vector& to, double line,
                   int direction) const;
  void see_run(int root, int row, int direction, const Run& run, const Limits& limits);
  void expand_pending();
  void advance(Cone cone);
  bool pass_full_rows(Cone& cone);
  void enter(const Cone& cone, int row, const Run& run);
  void arrive(const Cone& cone, double low, double high);

  double least_length(const Cone& cone, double low, double high) const;
  bool tangent_ray(const Root& root, const Vector& through, int direction, Line& ray) const;

  SearchSpace& space_;
  Roots& roots_;
  Queue& queue_;
  std::vector<Cone> pending_;
};

}  // namespace slalom::disc_path
