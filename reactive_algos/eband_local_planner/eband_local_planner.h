#pragma once

#include "common/local_map.h"
#include "eband_local_planner/follow_band.h"

#include <vector>

namespace eband_local_planner {

/// Lengths in m.
struct Parameters : BandParameters, ControllerParameters {
  double planner_frequency = 2;     ///< Hz; 0: a new path only if the band snaps or ends
  double footprint_padding = 0.05;  ///< added to the robot's radius
  double comfort = 0.3;             ///< clearance beyond which paths do not cost more
  double memory = 6;                ///< half the side length of the local map
};

/// An elastic band along the path of a navigation function on the local map, and the controller
/// that follows it.
class EbandLocalPlanner {
 public:
  using Parameters = eband_local_planner::Parameters;
  using Settings = reactive::Setting<Parameters>[23];
  static const Settings& settings();

  EbandLocalPlanner(const Parameters& parameters, const reactive::Robot& robot);
  void reset(const reactive::NavigationTask& task);
  reactive::Twist step(const reactive::Observation& observation);

 private:
  bool is_plan_due(const reactive::Point& position, const reactive::Point& goal);
  bool plan(const reactive::Point& position, const reactive::Point& goal);

  Parameters parameters_;
  reactive::Robot robot_;
  reactive::NavigationTask task_;
  reactive::LocalMap map_;
  reactive::CostToGo cost_to_go_;
  ElasticBand band_;
  double since_plan_ = 0;  ///< s
};

}  // namespace eband_local_planner
