// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <utility>
#include <vector>

/// Trajectory rollout: B. Gerkey and K. Konolige, "Planning and control in unstructured terrain",
/// ICRA Workshop on Path Planning on Costmaps, 2008. Velocities that the robot can reach
/// within the horizon are sampled, simulated with its acceleration limits, and scored by C = alpha
/// Obs + beta Gdist + gamma Pdist + delta / v^2 (section III).
namespace trajectory_rollout {

/// Lengths in m, times in s.
struct Parameters {
  double alpha = 1.0;          ///< weight of Obs, the lack of clearance along the trajectory
  double beta = 1.0;           ///< weight of Gdist, the remaining distance from its end to the goal
  double gamma = 0.4;          ///< weight of Pdist, the distance of its end from the path
  double delta = 0.003;        ///< weight of 1 / v^2
  double margin = 0.04;        ///< added to the robot's radius in collision checks
  double comfort = 0.3;        ///< clearance of the footprint beyond which there is no cost
  double horizon = 1.5;        ///< simulated time
  int v_samples = 8;           ///< linear velocities
  int w_samples = 25;          ///< angular velocities
  double turn_in_place = 1.3;  ///< rad: beyond this bearing of the path the robot rotates in place
  double memory = 15;          ///< half the side length of the local map
  double look_ahead = 1.5;     ///< length of the path that Pdist is measured from

  void visit(slalom::OptionVisitor& v);
};

/// The ranges in which the parameters are worth tuning.
std::vector<slalom_range> tuning_ranges();

/// Result of a simulated trajectory.
struct Rollout {
  reactive::Pose end;
  double clearance = 0;      ///< minimum footprint_clearance(), m
  double until_contact = 0;  ///< s
  bool collides = false;
  bool meets_mover = false;  ///< it collides with a mover
};

/// Velocities that are combined with each other.
struct VelocityGrid {
  std::vector<double> v, w;  ///< m/s; rad/s
};

/// Simulates the motions from `pose` with velocity `now`, towards each pair of `desired` velocities
/// (rows of equal v) within the acceleration limits, for `horizon` s. Movers (in the frame of the
/// pose) keep their velocities.
std::vector<Rollout> roll_out(const reactive::ClearanceMap& map, const reactive::Pose& pose,
                              const reactive::Twist& now, const VelocityGrid& desired,
                              const reactive::Robot& robot, double radius, double horizon,
                              const std::vector<reactive::Track>& movers = {});

class TrajectoryRollout {
 public:
  using Parameters = trajectory_rollout::Parameters;

  TrajectoryRollout(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(TrajectoryRollout& before);
  /// The movers of the next step.
  void set_tracks(std::vector<reactive::Track> tracks) { tracks_ = std::move(tracks); }
  reactive::Twist step(const reactive::Observation& observation);

 private:
  reactive::Observation without_movers(reactive::Observation observation) const;
  std::vector<reactive::Track> movers(const reactive::Pose& pose) const;
  bool is_met_standing() const;
  reactive::Twist best(const reactive::Observation& observation, const reactive::Waypoint& target,
                       double top_speed);
  double cost(const Rollout& rollout, const reactive::Twist& desired,
              const reactive::Waypoint& target);

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::LocalPlanner local_planner_;
  reactive::RotateInPlace turn_;
  double heading_look_ahead_ = 0;  ///< m ahead of a trajectory's end where its cost is evaluated
  std::vector<reactive::Point> path_;
  std::vector<reactive::Track> tracks_;  ///< robot frame
};

}  // namespace trajectory_rollout
