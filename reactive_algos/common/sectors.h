// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"

#include <cstddef>
#include <vector>

namespace reactive {

/// Input of MRPT's holonomic methods: the free distance of a point robot among enlarged obstacles
/// in each of n directions, from -pi upwards. Lengths are in the caller's unit; distances of at
/// least `limit` are free.
struct Sectors {
  std::vector<double> free_distances;
  double limit = 1;
  double meter = 1;  ///< in the same unit; 1 if the caller converts meters

  std::size_t count() const { return free_distances.size(); }
  double width() const { return 2 * M_PI / static_cast<double>(count()); }
  /// Center of sector k: -pi + (k + 1/2) 2 pi / n.
  double direction(std::size_t k) const { return -M_PI + (static_cast<double>(k) + 0.5) * width(); }
  std::size_t sector_of(double direction) const;
  double free_distance(double direction) const { return free_distances[sector_of(direction)]; }
  double min_free_distance() const;      ///< over all sectors
  static constexpr double kUnseen = -1;  ///< a free distance, closed
  /// Returns the sectors with those outside `field_of_view` unseen.
  Sectors ahead(double field_of_view) const;
};

/// Adjacent sectors from `first` on; the full circle if length == count().
struct SectorRun {
  std::size_t first = 0, length = 0;
};

/// Returns the runs of sectors with a free distance of at least `open`, around the circle.
std::vector<SectorRun> open_runs(const Sectors& sectors, double open);

/// An interval of free directions: rad, counter-clockwise from `low`, width >= 0.
struct Opening {
  double low = 0, width = 0;
  double high() const { return wrapped(low + width); }
  double middle() const { return wrapped(low + 0.5 * width); }
  /// The direction in it that is closest to `direction`, at least `margin` from its ends (its
  /// middle if it is narrower than twice that).
  double nearest_to(double direction, double margin) const;
  bool contains(double direction) const;
};

/// The interval of a run, between the outer edges of its first and last sector.
Opening opening_of(const Sectors& sectors, const SectorRun& run);

/// Output of a method: direction (rad) and speed (fraction of the maximum).
struct Decision {
  double direction = 0, speed = 0;
};

/// Rotation in search of an opening, always to the side where it started.
class SearchTurn {
 public:
  void reset() { side_ = 0; }
  Decision next(double target_direction);

 private:
  int side_ = 0;  ///< +1 left, -1 right, 0 none yet
};

/// Minimum speed fraction of a moving robot.
constexpr double kMinSpeedFraction = 0.1;

/// Fraction of the maximum speed for a free distance ahead: 1 from `slow_distance` on, also reduced
/// near the target.
double speed_fraction(double free_distance, double target_distance, double slow_distance,
                      double target_distance_slow);

}  // namespace reactive
