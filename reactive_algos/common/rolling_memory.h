// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"
#include "common/robot.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reactive {

/// Obstacle points of past scans around the robot. Points are in the odometry frame, at most one
/// per cell of a square window that moves with the robot. A point is removed when it leaves the
/// window or when later scans see through it.
class RollingMemory {
 public:
  /// half_size: m, from the robot to the border of the window; resolution: m, cell size.
  RollingMemory(double half_size, double resolution);

  void clear();
  /// Forgets the points outside a square around `center`.
  void clear_outside(const Point& center, double half_size);
  /// Forgets the points in the cells that rays lead through, up to `range` m, as ROS's costmap_2d
  /// clears its cells, so that noise does not add up.
  void clear_along(const Pose& pose, const std::vector<double>& ranges, const Robot& robot,
                   double range);
  /// Rays with a negative range say nothing.
  void update(const Pose& pose, const std::vector<double>& ranges, const Robot& robot);
  const std::vector<Point>& points() const { return points_; }  ///< odometry frame
  double half_size() const { return half_size_; }

 private:
  std::int64_t cell_of(double coordinate) const;
  std::size_t slot_of(const Point& p) const;
  void insert(const Point& p);
  void remove(std::size_t index);
  static bool sees_through(const Point& local, const std::vector<double>& ranges,
                           const Robot& robot);
  void aim(std::size_t rays, double aperture);

  double half_size_, resolution_;
  std::int64_t cells_;               ///< along one side of the window
  std::vector<std::int32_t> index_;  ///< of the point in each cell, -1 for none; wraps around
  std::vector<Point> points_;
  std::vector<Point> rays_;  ///< unit vectors of the rays, robot frame
  double aperture_ = 0;      ///< of these
};

}  // namespace reactive
