#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <boost/random/mersenne_twister.hpp>

#include <vector>

/// Model predictive path integral control: G. Williams, N. Wagener, B. Goldfain, P. Drews, J. Rehg,
/// B. Boots and E. Theodorou, "Information theoretic MPC for model-based reinforcement learning",
/// ICRA 2017; algorithm and equation numbers refer to it. Noise comes from the run's seed.
namespace mppi {

/// Lengths in m, times in s.
struct Parameters {
  double samples = 400;          ///< K, rollouts a cycle
  double steps = 24;             ///< T, control periods that a rollout looks ahead
  double lambda = 0.3;           ///< temperature: how much better than the rest counts
  double noise_v = 0.2;          ///< m/s, standard deviation of the noise on v
  double hold = 4;               ///< control periods for which a noise value lasts
  double noise_w = 0.6;          ///< rad/s, standard deviation of the noise on w
  double control_cost = 0.02;    ///< gamma of the control term, as a share of lambda
  double margin = 0.04;          ///< added to the robot's radius: nearer is a collision
  double comfort = 0.3;          ///< clearance of the footprint that costs nothing
  double obstacle_weight = 1.5;  ///< m of way that a second at the least clearance costs
  double goal_weight = 4.0;      ///< weight of the way that is left at the end of a rollout
  double turn_in_place = 1.6;    ///< rad: a way farther aside is turned to without driving
  double memory = 6;             ///< half the side of the local map
};

/// Weights of rollouts with these costs, Algorithm 2: exp(-(S - min S) / lambda), divided by their
/// sum.
std::vector<double> importance_weights(const std::vector<double>& costs, double lambda);

/// Normal numbers for steps of two speeds. Each lasts for `hold` steps: single steps would average
/// out over a rollout, and hundreds of rollouts would not find a turn.
class Noise {
 public:
  void seed(std::uint64_t seed);
  /// `rollouts` rows of `steps`.
  void draw(std::vector<reactive::Speeds>& out, std::size_t rollouts, std::size_t steps,
            std::size_t hold, double sigma_v, double sigma_w);

 private:
  boost::random::mt19937_64 engine_;
};

class Mppi {
 public:
  using Parameters = mppi::Parameters;
  using Settings = reactive::Setting<Parameters>[13];
  static const Settings& settings();

  Mppi(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::Task& task);
  reactive::Speeds step(const reactive::Observation& observation);

 private:
  void optimise(const reactive::Observation& observation, const reactive::Waypoint& target,
                double top_speed);
  double rollout_cost(const reactive::Observation& observation, const reactive::Waypoint& target,
                      double top_speed, double radius, const reactive::Speeds* noise);
  double way_left(const reactive::Pose& pose, const reactive::Waypoint& target) const;
  void shift();

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::Task task_;
  reactive::LocalMap map_;
  reactive::Guide guide_;
  reactive::TurnOnTheSpot turn_;
  double look_ = 0;  ///< m ahead of a trajectory's end from which its way to the goal is measured
  Noise noise_;
  std::vector<reactive::Speeds> plan_;         ///< mean controls, one a step
  std::vector<reactive::Speeds> disturbance_;  ///< K rows of T
};

}  // namespace mppi
