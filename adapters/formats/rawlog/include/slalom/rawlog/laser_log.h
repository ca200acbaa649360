// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/log_objects.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One 2D scan of a rawlog, with the latest odometry before it.
struct LoggedScan {
  mrpt::obs::CObservation2DRangeScan::ConstPtr scan;
  double time = 0;  ///< s since the first scan; 0 if the log has no timestamps
  std::optional<mrpt::math::TPose2D> odometry;   ///< m, rad
  std::optional<mrpt::math::TTwist2D> velocity;  ///< m/s, rad/s, robot frame
};

/// All 2D scans of a log: a rawlog in either of MRPT's formats (observations; actions and sensory
/// frames) or a bag, in the order of the file. Velocities are those of the odometry, or else
/// differences of its poses. `label` selects one sensor by its label; empty selects all. Throws
/// Error (File) with file and reason if the file is missing, corrupt, truncated, or contains no
/// such scan.
std::vector<LoggedScan> read_laser_log(const LogObjects& log, const std::string& label = "");
std::vector<LoggedScan> read_laser_log(const std::string& path, const std::string& label = "");

}  // namespace slalom
