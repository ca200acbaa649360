// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "occupied_rows.h"

#include <utility>

namespace slalom::disc_path {

/// Angles [first, second] (rad).
using Interval = std::pair<double, double>;

/// A convex corner of the occupied cells: exactly one of the four cells at the vertex is occupied.
/// Its arc is the quarter of a circle of the robot's radius in the quadrant (out_x, out_y), each -1
/// or +1, opposite to that cell. Angles along it are local: 0 in the direction (out_x, 0), pi/2 in
/// the direction (0, out_y).
struct Arc {
  int x = 0, y = 0;
  int out_x = 0, out_y = 0;
  bool is_exposure_known = false;
  std::vector<Interval> exposed{};  ///< where the disc is free
  int labels[2] = {-1, -1};         ///< of the search: the last one turning right, left

  Vector center() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

/// The parts of the arc of `arc` at whose points a disc of radius `checked_radius` is free.
std::vector<Interval> exposed_parts(const OccupiedRows& occupied, const Arc& arc, double radius,
                                    double checked_radius);

/// The arcs of an occupancy by the rows that they cross, prepared when a row is first needed.
class ArcRows {
 public:
  ArcRows(const OccupiedRows& occupied, double radius);

  Arc& operator[](int i) { return arcs_[static_cast<std::size_t>(i)]; }

  /// The indexes of all arcs that cross [low, high] in row y, some others nearby, some repeated.
  std::pair<const int*, const int*> near(int y, double low, double high);

 private:
  static constexpr int kBucketBits = 3;  // a bucket has 8 cells

  struct Row {
    std::vector<int> begin;    ///< of each bucket in `entries`; empty if not prepared
    std::vector<int> entries;  ///< indexes of arcs
  };
  struct Corners {
    bool is_prepared = false;
    int begin = 0, end = 0;  ///< indexes of its arcs
  };

  int bucket_of(double x) const;
  const Corners& corners_on(int line);
  void add_corner(int x, int line);
  void prepare(int y);
  /// Calls visit(arc, first bucket, last bucket) for all arcs that cross row y.
  template <typename Visit>
  void for_crossing(int y, Visit visit);

  const OccupiedRows& occupied_;
  double radius_;
  int buckets_;
  std::vector<Arc> arcs_;
  std::vector<Corners> corners_;  ///< by line y = 0 .. size_y
  std::vector<Row> rows_;
};

}  // namespace slalom::disc_path
