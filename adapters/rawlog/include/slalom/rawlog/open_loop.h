#pragma once

#include <slalom/methods/method.h>
#include <slalom/rawlog/laser_log.h>
#include <slalom/robot/vehicle.h>

#include <mrpt/math/TPoint2D.h>

#include <string>
#include <vector>

namespace slalom {

/// A foreign scan as points about the robot's centre (m; x ahead, y left): its valid ranges,
/// brought from the sensor's place on the robot into the plane. Empty for a scan that is not
/// planar.
std::vector<mrpt::math::TPoint2D> scan_points(const mrpt::obs::CObservation2DRangeScan& scan);

/// What the campaign's sensor, at the robot's centre, would have seen of a foreign scan. Each of
/// its points covers the angle between it and its neighbours in the scan; each ray has the nearest
/// point that covers it. What the scan does not show is free.
mrpt::obs::CObservation2DRangeScan resample_scan(const mrpt::obs::CObservation2DRangeScan& scan,
                                                 const SensorModel& sensor);

/// Where a command would have led, by what one scan shows.
struct Forecast {
  bool at_once = false;     ///< the scan shows points within the footprint already: nothing is said
  bool stopping = false;    ///< contact though the robot brakes after one control period
  bool one_second = false;  ///< contact when the command is held for a second
};

/// Drives the robot from its velocity when the command comes; points as scan_points() gives them.
Forecast foresee_contact(const RobotModel& robot, double control_period, const Velocity& velocity,
                         const Command& command, const std::vector<mrpt::math::TPoint2D>& points);

/// How a method answered one scan of a log.
struct OpenLoopAnswer {
  double time = 0;      ///< s since the first scan
  std::string problem;  ///< why there is no command that the robot could take; "" otherwise
  Command command;
  Forecast forecast;
  int unseen_rays = 0;  ///< rays of the campaign's sensor at which the log's did not look
};

/// What every scan is answered with.
struct OpenLoopSetup {
  RobotModel robot;
  SensorModel sensor;
  double control_period = 0.1;  ///< s
  double goal_tolerance = 0.2;  ///< m
  double goal_ahead = 5;        ///< m: where the goal is, straight ahead of the robot
};

/// Gives each scan to the method as the first cycle of a run of its own (reset, then one step),
/// with the log's odometry where it has one.
std::vector<OpenLoopAnswer> replay_open_loop(const std::vector<LoggedScan>& scans,
                                             const OpenLoopSetup& setup, Method& method);

}  // namespace slalom
