// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/local_map.h"
#include "common/motion.h"
#include "mppi/rollouts.h"

#include <vector>

/// Model predictive path integral control: G. Williams, N. Wagener, B. Goldfain, P. Drews, J. Rehg,
/// B. Boots and E. Theodorou, "Information theoretic MPC for model-based reinforcement learning",
/// ICRA 2017; algorithm and equation numbers refer to it. Noise comes from the run's seed.
namespace mppi {

/// Lengths in m, times in s.
struct Parameters {
  int samples = 400;             ///< K, rollouts per cycle
  int steps = 24;                ///< T, control periods per rollout
  double lambda = 0.3;           ///< temperature of the weights
  double noise_v = 0.2;          ///< m/s, standard deviation of the noise on v
  int hold = 4;                  ///< control periods for which a noise sample is held
  double noise_w = 0.6;          ///< rad/s, standard deviation of the noise on w
  double control_cost = 0.02;    ///< gamma of the control term, as a fraction of lambda
  double margin = 0.04;          ///< added to the robot's radius in collision checks
  double comfort = 0.3;          ///< clearance of the footprint beyond which there is no cost
  double obstacle_weight = 1.5;  ///< path length (m) equivalent to one second at minimum clearance
  double goal_weight = 4.0;      ///< weight of the remaining distance at the end of a rollout
  double turn_in_place = 1.6;  ///< rad: beyond this bearing of the path the robot rotates in place
  double memory = 15;          ///< half the side length of the local map

  void visit(slalom::OptionVisitor& v);
};

/// Normalized weights of rollouts with these costs, Algorithm 2: exp(-(S - min S) / lambda).
std::vector<double> importance_weights(const std::vector<double>& costs, double lambda);

class Mppi {
 public:
  using Parameters = mppi::Parameters;

  Mppi(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(Mppi& before);
  reactive::Twist step(const reactive::Observation& observation);

 private:
  void optimize(const reactive::Observation& observation, const reactive::Waypoint& target,
                double top_speed);
  CostRule cost_rule(const reactive::Observation& observation, double top_speed) const;
  void shift();

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::LocalPlanner local_planner_;
  reactive::RotateInPlace turn_;
  Noise noise_;
  std::vector<reactive::Twist> plan_;  ///< mean controls, one per step
};

}  // namespace mppi
