// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/clearance_map.h"

#include <cstddef>
#include <utility>
#include <vector>

/// Elastic bands: S. Quinlan and O. Khatib, "Elastic Bands: Connecting Path Planning and Control",
/// ICRA 1993, 802-807. Parameters have the names and default values of the ROS package
/// eband_local_planner (C. Connette and B. Marthi). Positions are in the odometry frame, lengths in
/// m; forces have no unit.
namespace eband_local_planner {

/// Parameters of the band.
struct BandParameters {
  double eband_min_relative_overlap = 0.7;    ///< of the sum of radii: distance of neighbors
  double eband_tiny_bubble_distance = 0.01;   ///< neighbors this close exert no force
  double eband_tiny_bubble_expansion = 0.01;  ///< radius of a bubble in collision
  double eband_internal_force_gain = 1;       ///< k_c
  double eband_external_force_gain = 2;       ///< k_r
  int num_iterations_eband_optimization = 3;
  int eband_equilibrium_approx_max_recursion_depth = 4;  ///< of steps that overshoot
  double eband_equilibrium_relative_overshoot = 0.75;
  double eband_significant_force_lower_bound = 0.15;
  double costmap_weight = 10;      ///< 1/m, cost_scaling_factor of the costmap
  double inflation_radius = 0.55;  ///< clearance beyond which bubbles have the maximum radius
};

/// The radius of bubbles in free space: a costmap has 252 exp(-costmap_weight radius) = 1 there.
double max_radius(const BandParameters& parameters);

/// A disc around a position of the robot: within it the robot's center can move freely.
struct Bubble {
  reactive::Point center;
  double radius = 0;
};

/// A path as a chain of bubbles, each of which overlaps with the next one. The first one is that of
/// the robot and the last one that of the path's end; both are fixed. All others move to where a
/// contraction and a repulsion by obstacles are in equilibrium.
class ElasticBand {
 public:
  /// Bubbles are measured on `map`, which must outlive the band.
  ElasticBand(const BandParameters& parameters, const reactive::ClearanceMap& map,
              double robot_radius)
      : parameters_(parameters), map_(map), robot_radius_(robot_radius) {}

  void clear() { bubbles_.clear(); }
  void take_over(ElasticBand& before) {
    bubbles_ = std::move(before.bubbles_);
    clearance_ = before.clearance_;
  }
  /// Replaces the band by one along `path`, which begins at the robot, that keeps a clearance of at
  /// least `clearance`; less only if the robot is closer to an obstacle. Returns false, with an
  /// empty band, if there is an obstacle on the path.
  bool set_path(const std::vector<reactive::Point>& path, double clearance);
  /// Adapts the band to the robot's position and to the current map: connects the robot's bubble to
  /// the farthest one that overlaps with it, and optimizes. Returns false, with an empty band, if
  /// the band has snapped.
  bool update(const reactive::Point& robot);

  const std::vector<Bubble>& bubbles() const { return bubbles_; }
  /// The force on bubble `i`, neither the first nor the last one: at rest it is small.
  reactive::Point force(std::size_t i) const { return force_at(i, bubbles_[i]); }

 private:
  void limit_clearance(const reactive::Point& robot);
  Bubble bubble_at(const reactive::Point& center) const;
  bool is_tiny(const Bubble& bubble) const;
  bool overlap(const Bubble& a, const Bubble& b) const;
  bool fill(const Bubble& a, const Bubble& b, std::vector<Bubble>& filled) const;
  bool refine();
  bool optimize();
  reactive::Point contraction(const Bubble& bubble, const Bubble& neighbor) const;
  reactive::Point repulsion(const Bubble& bubble) const;
  reactive::Point force_at(std::size_t i, const Bubble& bubble) const;
  void move(std::size_t i);
  Bubble equilibrium(std::size_t i, const reactive::Point& force) const;

  BandParameters parameters_;
  const reactive::ClearanceMap& map_;
  double robot_radius_;
  double clearance_ = 0;  ///< of a bubble of radius 0
  std::vector<Bubble> bubbles_;
};

}  // namespace eband_local_planner
