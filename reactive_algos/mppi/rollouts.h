// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/footprint.h"
#include "common/local_map.h"

#include <boost/random/mersenne_twister.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mppi {

/// The first rollouts: the unchanged plan, and braking. They have no random noise.
enum FixedRollout : std::size_t { Unchanged, Braking };
constexpr std::size_t kFixedRollouts = 2;

/// Normally distributed noise of both velocities of all rollouts. Each sample is held for `hold`
/// steps: independent steps would average out over a rollout, so that no rollout would contain a
/// turn.
class Noise {
 public:
  void seed(std::uint64_t seed);
  /// Standard deviations: m/s and rad/s.
  void draw(std::size_t rollouts, std::size_t steps, std::size_t hold, double sigma_v,
            double sigma_w);

  std::size_t rollouts() const { return rollouts_; }
  /// Noise of each rollout in a step, m/s and rad/s.
  const double* v(std::size_t step) const { return &v_[step / hold_ * rollouts_]; }
  const double* w(std::size_t step) const { return &w_[step / hold_ * rollouts_]; }

 private:
  boost::random::mt19937_64 engine_;
  std::size_t rollouts_ = 0, hold_ = 1;
  std::vector<double> v_, w_;  ///< rows of samples that are held at the same time
};

/// Cost S of a rollout, Algorithm 2: state costs, control term gamma u^T Sigma^-1 epsilon, and
/// terminal cost. Lengths in m, times in s.
struct CostRule {
  double period = 0.1;                  ///< of a step
  double top_speed = 1;                 ///< m/s
  double radius = 0.29;                 ///< clearances below this are collisions
  double span = 0.3;                    ///< of clearances above the radius that have a cost
  double obstacle_weight = 1.5;         ///< m/s, at the radius
  double goal_weight = 4;               ///< of the distance that remains at the end
  double control_v = 0, control_w = 0;  ///< gamma / sigma^2 of both velocities
  double look_ahead = 0.3;              ///< distance ahead of the end where the rest is measured
};

/// Costs of all rollouts of `plan` with `noise`.
std::vector<double> rollout_costs(const CostRule& rule, const reactive::Robot& robot,
                                  const reactive::Observation& start,
                                  const std::vector<reactive::Twist>& plan, const Noise& noise,
                                  const reactive::ClearanceMap& map,
                                  const reactive::Waypoint& target, reactive::CostToGo& cost_to_go);

}  // namespace mppi
