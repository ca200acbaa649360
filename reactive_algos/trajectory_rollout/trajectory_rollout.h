#pragma once

#include "common/local_map.h"
#include "common/motion.h"

#include <vector>

/// Trajectory rollout: B. Gerkey and K. Konolige, "Planning and control in unstructured terrain",
/// ICRA Workshop on Path Planning on Costmaps, 2008. Speeds are sampled among all that the robot
/// can reach within the horizon, simulated under its accelerations, and scored by C = alpha Obs +
/// beta Gdist + gamma Pdist + delta / v^2, as named in their section III.
namespace trajectory_rollout {

/// Lengths in m, times in s.
struct Parameters {
  double alpha = 1.0;          ///< weight of Obs, the lack of clearance along the trajectory
  double beta = 1.0;           ///< weight of Gdist, the way from its end to the goal
  double gamma = 0.4;          ///< weight of Pdist, the distance of its end from the path
  double delta = 0.003;        ///< weight of 1 / v^2
  double margin = 0.04;        ///< added to the robot's radius: nearer is a collision
  double comfort = 0.3;        ///< clearance of the footprint that costs nothing
  double horizon = 1.5;        ///< simulated
  double v_samples = 8;        ///< speeds
  double w_samples = 25;       ///< turning speeds
  double turn_in_place = 1.3;  ///< rad: a way farther aside is turned to without driving
  double memory = 6;           ///< half the side of the local map
  double look_ahead = 1.5;     ///< length of the path that Pdist is measured from
};

/// A simulated trajectory: where it ends, and how near it came to something.
struct Rollout {
  reactive::Pose end;
  double clearance = 0;      ///< m, of the robot's centre, smallest
  double until_contact = 0;  ///< s
  bool collides = false;
};

/// Drives from `pose` with `now`, towards `wanted` as the accelerations allow, for `horizon` s.
Rollout roll_out(const reactive::ClearanceMap& map, const reactive::Pose& pose,
                 const reactive::Speeds& now, const reactive::Speeds& wanted,
                 const reactive::Robot& robot, double radius, double horizon);

class TrajectoryRollout {
 public:
  using Parameters = trajectory_rollout::Parameters;
  using Settings = reactive::Setting<Parameters>[12];
  static const Settings& settings();

  TrajectoryRollout(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::Task& task);
  reactive::Speeds step(const reactive::Observation& observation);

 private:
  reactive::Speeds best(const reactive::Observation& observation, const reactive::Waypoint& target,
                        double top_speed);
  double cost(const Rollout& rollout, const reactive::Speeds& wanted,
              const reactive::Waypoint& target) const;

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::Task task_;
  reactive::LocalMap map_;
  reactive::Guide guide_;
  reactive::TurnOnTheSpot turn_;
  double look_ = 0;  ///< m ahead of a trajectory's end from which its way to the goal is measured
  std::vector<reactive::Point> path_;
};

}  // namespace trajectory_rollout
