// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/global_planner.h"
#include "common/local_map.h"
#include "eband_local_planner/follow_band.h"

#include <vector>

namespace eband_local_planner {

/// Lengths in m.
struct Parameters : BandParameters, ControllerParameters {
  double planner_frequency = 2;     ///< Hz; 0: a new path only if the band snaps or ends
  double footprint_padding = 0.05;  ///< added to the robot's radius
  double comfort = 0.3;             ///< clearance beyond which paths do not cost more
  double memory = 15;               ///< half the side length of the local map
  reactive::PathMap map = reactive::PathMap::Sensed;

  void visit(slalom::OptionVisitor& v);
};

/// An elastic band along the path of a navigation function on the local map, or of a global planner
/// on the known map, and the controller that follows it.
class EbandLocalPlanner {
 public:
  using Parameters = eband_local_planner::Parameters;

  EbandLocalPlanner(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  /// Goes on with the run of an object that has other parameters.
  void take_over(EbandLocalPlanner& before);
  bool uses_map() const { return parameters_.map == reactive::PathMap::Known; }
  /// Sets the map of the environment, with map = known. Call before step().
  void set_map(const reactive::KnownMap& map) { global_map_.set_known(map); }
  reactive::Twist step(const reactive::Observation& observation);

 private:
  bool is_plan_due(const reactive::Point& position, const reactive::Point& goal);
  bool plan(const reactive::Point& position, const reactive::Point& goal);
  std::vector<reactive::Point> path_to(const reactive::Point& goal, const reactive::Point& position,
                                       double clearance);

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::CostToGo cost_to_go_;
  reactive::GlobalCostmap global_map_;
  reactive::GlobalPlanner global_planner_;
  ElasticBand band_;
  double since_plan_ = 0;  ///< s
};

}  // namespace eband_local_planner
