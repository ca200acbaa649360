// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/log_objects.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <string>
#include <vector>

namespace slalom {

/// A velocity of the robot, commanded or measured.
struct LoggedVelocity {
  double time = 0;  ///< s since the first of the log's velocities and scans
  double v = 0;     ///< m/s
  double w = 0;     ///< rad/s
};

/// A scan with the time of its timestamp.
struct TimedScan {
  double time = 0;  ///< s, as in LoggedVelocity
  mrpt::obs::CObservation2DRangeScan::ConstPtr scan;
};

/// Labels of the observations that are read; the defaults are those of recorded runs.
struct MotionLabels {
  std::string command = "command";    ///< CObservationOdometry whose velocity is the command
  std::string odometry = "odometry";  ///< CObservationOdometry with the measured velocity
  std::string scan;                   ///< of the range sensor; empty: that of the first scan
};

/// Commands, measured velocities and scans of a robot, each in order of time.
struct MotionLog {
  MotionLabels labels;
  std::vector<std::string> odometry_labels;  ///< all labels of CObservationOdometry in the log
  std::vector<LoggedVelocity> commands, odometry;
  std::vector<TimedScan> scans;  ///< of one sensor: the same label and number of rays
};

/// Reads a rawlog in either of MRPT's formats (observations; actions and sensory frames) or a bag.
/// Odometry without velocities gives those between its poses, at the middle of their times.
/// Observations without timestamp or with velocities that are not finite are left out. Throws Error
/// (File) with file and reason if the file is missing, corrupt or truncated.
MotionLog read_motion_log(const LogObjects& log, const MotionLabels& labels = {});
MotionLog read_motion_log(const std::string& path, const MotionLabels& labels = {});

}  // namespace slalom
