// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <optional>
#include <utility>
#include <vector>

namespace slalom {

/// The area of a scenario's obstacles in the frame of its task: the start at the origin, the goal
/// on the positive x axis. Movers count with the area that they sweep; the border does not count.
/// So scenarios of different workspaces are compared by where the obstacles are for the robot.
class ObstacleArea {
 public:
  /// `resolution` (m): the size of the cells in which areas are measured, and those of continuous
  /// scenarios.
  ObstacleArea(const Scenario& scenario, double resolution);

  /// The Jaccard distance of the two areas: 1 - common area / area of the union, in [0, 1]; 0 if
  /// both are empty. Both must have the same resolution.
  double dissimilarity(const ObstacleArea& other) const;

 private:
  std::vector<std::pair<int, int>> cells_;  ///< ascending
};

/// Two failures whose obstacles have at least half of their united area in common are alike.
constexpr double kMinDissimilarity = 0.5;

/// Whether it is not alike any of `others`.
bool is_distinct(const ObstacleArea& area, const std::vector<ObstacleArea>& others);

/// The mean dissimilarity of all pairs; nullopt for less than two scenarios.
std::optional<double> diversity(const std::vector<ObstacleArea>& areas);

}  // namespace slalom
