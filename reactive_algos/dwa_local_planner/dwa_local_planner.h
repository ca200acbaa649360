// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/global_planner.h"
#include "common/plugin.h"
#include "common/rolling_memory.h"
#include "dwa_local_planner/oscillation.h"
#include "dwa_local_planner/recovery.h"
#include "dwa_local_planner/trajectory_scorer.h"

#include <vector>

/// The dynamic window approach as the ROS navigation stack runs it: move_base with navfn,
/// costmap_2d and dwa_local_planner (E. Marder-Eppstein, E. Berger, T. Foote, B. Gerkey and
/// K. Konolige, "The Office Marathon: Robust Navigation in an Indoor Office Environment", ICRA
/// 2010), after D. Fox, W. Burgard and S. Thrun, "The Dynamic Window Approach to Collision
/// Avoidance", IEEE Robotics and Automation Magazine 4(1), 1997.
namespace dwa_local_planner {

class DwaLocalPlanner {
 public:
  using Parameters = dwa_local_planner::Parameters;

  DwaLocalPlanner(const Parameters& parameters, const reactive::Robot& robot);
  bool uses_map() const { return parameters_.map == reactive::PathMap::Known; }
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(DwaLocalPlanner& before);
  void set_map(const reactive::KnownMap& map) { global_map_.set_known(map); }
  reactive::Twist step(const reactive::Observation& observation);

 private:
  /// Time (s) without a path, a trajectory and progress.
  struct Waiting {
    double plan = 0, control = 0, progress = 0;
  };

  void set_goal_tolerance();
  bool plan(const reactive::Pose& pose);
  std::vector<reactive::Point> local_path(const reactive::Pose& pose);
  bool follow_path(const reactive::Observation& observation, reactive::Twist& best);
  void count_time(const reactive::Pose& pose);
  bool is_stuck() const;

  Parameters parameters_;
  reactive::Robot robot_;  ///< with the range in which obstacles are marked
  reactive::NavigationTask task_;
  double goal_tolerance_ = 0;  ///< m, at which it stops
  reactive::RollingMemory memory_;
  TrajectoryScorer scorer_;
  reactive::Costmap local_map_;
  reactive::GlobalCostmap global_map_;
  reactive::GlobalPlanner planner_;
  OscillationCritic oscillation_;
  Recovery recovery_;

  std::vector<reactive::Point> path_;
  double since_plan_ = 0;  ///< s, since the path was planned
  Waiting waiting_;
  reactive::Point progress_from_;
};

}  // namespace dwa_local_planner
