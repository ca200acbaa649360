// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/methods/method.h>
#include <slalom/rawlog/laser_log.h>
#include <slalom/robot/range_scan.h>
#include <slalom/robot/vehicle.h>

#include <mrpt/math/TPoint2D.h>

#include <string>
#include <vector>

namespace slalom {

/// A logged scan as one of the campaign's sensor at the robot's center: merged_ranges().
mrpt::obs::CObservation2DRangeScan resample_scan(const mrpt::obs::CObservation2DRangeScan& scan,
                                                 const SensorModel& sensor);

/// Predicted contact with the points of one scan.
struct ContactPrediction {
  bool in_contact = false;  ///< points within the footprint at the start; the others stay false
  bool stopping = false;    ///< contact although the robot brakes after one control period
  bool one_second = false;  ///< contact if the command is held for one second
};

/// Simulates the robot, starting with `velocity`; `points` as returned by scan_points().
ContactPrediction predict_contact(const RobotModel& robot, double control_period,
                                  const Velocity& velocity, const Command& command,
                                  const std::vector<mrpt::math::TPoint2D>& points);

/// The answer of a method to one scan of a log.
struct OpenLoopAnswer {
  double time = 0;      ///< s since the first scan
  std::string problem;  ///< why there is no valid command; "" otherwise
  Command command;
  ContactPrediction prediction;
  int uncovered_rays = 0;  ///< rays of the campaign's sensor outside the scan
};

/// Parameters of an open-loop replay.
struct OpenLoopSetup {
  RobotModel robot;
  SensorModel sensor;
  double control_period = 0.1;  ///< s
  double goal_tolerance = 0.2;  ///< m
  double goal_ahead = 5;        ///< distance of the goal straight ahead of the robot, m
};

/// Passes each scan to the method as the first cycle of a separate run (reset, then one step), with
/// the log's odometry if available.
std::vector<OpenLoopAnswer> replay_open_loop(const std::vector<LoggedScan>& scans,
                                             const OpenLoopSetup& setup, Method& method);

}  // namespace slalom
