// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/clearance_map.h"

#include <cstdint>
#include <vector>

namespace reactive {

/// How costs decay with the distance from obstacles, with the parameters of the inflation layer of
/// ROS's costmap_2d: D. Lu, D. Hershberger and W. Smart, "Layered Costmaps for Context-Sensitive
/// Navigation", IROS 2014; wiki.ros.org/costmap_2d.
struct Inflation {
  static constexpr std::uint8_t kLethal = 254, kInscribed = 253, kFree = 0;

  double inscribed_radius = 0.25;   ///< m, of the footprint
  double inflation_radius = 0.55;   ///< m: farther cells are free
  double cost_scaling_factor = 10;  ///< 1/m

  /// The cost of a cell whose center is `distance` (m) from that of the closest obstacle cell:
  /// lethal at 0, inscribed up to the inscribed radius, then 252 exp(-factor (distance - radius)).
  std::uint8_t cost(double distance) const;
};

/// A square grid of costs around a center. Obstacle points count as the centers of their cells.
class Costmap {
 public:
  /// half_size, resolution: m. Clearances are computed up to `band` (m), and at least up to the
  /// inflation radius.
  Costmap(double half_size, double resolution, const Inflation& inflation, double band = 0);

  void build(const Point& center, const std::vector<Point>& points);

  std::uint8_t cost(int x, int y) const { return cost_at(clearance_.cell(x, y)); }
  std::uint8_t cost(const Point& p) const;  ///< kFree outside the square
  /// Distances to the centers of obstacle cells.
  const ClearanceMap& clearance() const { return clearance_; }
  const Inflation& inflation() const { return inflation_; }

 private:
  std::uint8_t cost_at(float distance) const {
    // Distances are not negative, and std::lround() would be a call for each cell.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return costs_[static_cast<std::size_t>(distance * kPerMeter + 0.5F)];
  }

  static constexpr float kPerMeter = 1000;  // costs are tabulated per mm

  Inflation inflation_;
  ClearanceMap clearance_;
  std::vector<std::uint8_t> costs_;  ///< by distance
  std::vector<Point> centers_;       ///< of obstacle cells
};

}  // namespace reactive
