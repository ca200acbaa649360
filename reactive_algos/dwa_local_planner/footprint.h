// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/costmap.h"
#include "common/robot.h"

#include <slalom/core/math.h>

#include <cstdint>
#include <vector>

namespace dwa_local_planner {

/// The outline of a robot on a costmap.
class Footprint {
 public:
  /// The robot's polygon, or a regular one of 16 corners around the disc's center, enlarged by
  /// `padding` (m) in x and y, as in costmap_2d.
  Footprint(const reactive::Robot& robot, double padding);

  /// The same, its corners `factor` times as far from the center.
  Footprint scaled(double factor) const;

  double inscribed_radius() const { return inscribed_radius_; }          ///< m
  double circumscribed_radius() const { return circumscribed_radius_; }  ///< m

  /// The highest cost of the cells under the outline; lethal if it touches an obstacle cell.
  std::uint8_t cost(const reactive::Costmap& map, const reactive::Pose& pose) const {
    return cost(map, {pose.x, pose.y}, slalom::math::cos(pose.phi), slalom::math::sin(pose.phi));
  }
  std::uint8_t cost(const reactive::Costmap& map, const reactive::Point& position, double cosine,
                    double sine) const;

 private:
  explicit Footprint(std::vector<reactive::Point> corners);

  std::vector<reactive::Point> corners_;
  double inscribed_radius_, circumscribed_radius_;
};

}  // namespace dwa_local_planner
