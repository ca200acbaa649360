#pragma once

#include "common/geometry.h"

#include <cstddef>
#include <vector>

namespace reactive {

/// What MRPT's holonomic methods see: how far a robot, as a point among obstacles that are enlarged
/// by it, can go in each of n directions, counted from -pi upwards. Lengths are in the caller's
/// unit; `limit` and more is free.
struct Sectors {
  std::vector<double> ways;
  double limit = 1;

  std::size_t count() const { return ways.size(); }
  double width() const { return 2 * kPi / static_cast<double>(count()); }
  /// Centre of sector k: -pi + (k + 1/2) 2 pi / n.
  double direction(std::size_t k) const { return -kPi + (static_cast<double>(k) + 0.5) * width(); }
  std::size_t sector_of(double direction) const;
  double way(double direction) const { return ways[sector_of(direction)]; }
  double nearest() const;  ///< the shortest way
  /// Only what lies ahead within `field_of_view`: the rest is closed.
  Sectors ahead(double field_of_view) const;
};

/// Sectors of one kind next to each other, from `first` on, all around if count() == all.
struct SectorRun {
  std::size_t first = 0, length = 0;
};

/// The runs of sectors whose way is at least `open`, around the circle, from -pi on.
std::vector<SectorRun> open_runs(const Sectors& sectors, double open);

/// Directions between which the robot can leave: rad, counter-clockwise from `low`, width >= 0.
struct Opening {
  double low = 0, width = 0;
  double high() const { return wrapped(low + width); }
  double middle() const { return wrapped(low + 0.5 * width); }
  /// The direction in it that is nearest to `direction`, at least `inside` from its ends (or in its
  /// middle, where it is narrower than twice that).
  double nearest_to(double direction, double inside) const;
  bool contains(double direction) const;
};

/// The borders of a run: the outer edges of its first and last sector.
Opening opening_of(const Sectors& sectors, const SectorRun& run);

/// What a method answers: where to, and how fast (a share of the largest speed).
struct Decision {
  double direction = 0, speed = 0;
};

/// To where a robot turns that sees no way out: on to the side that it began with.
class SearchTurn {
 public:
  void end() { side_ = 0; }
  Decision next(double target_direction);

 private:
  int side_ = 0;  ///< +1 left, -1 right, 0 none yet
};

/// Least speed share of a robot that has not stopped.
constexpr double kCreep = 0.1;

/// The share of the largest speed for `way` ahead: all of it from `slow_distance` on, slower near
/// the target, too.
double speed_share(double way, double target_distance, double slow_distance,
                   double target_distance_slow);

}  // namespace reactive
