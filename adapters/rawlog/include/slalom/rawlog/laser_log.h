#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// One 2D scan of any rawlog, with what odometry last said before it.
struct LoggedScan {
  mrpt::obs::CObservation2DRangeScan::ConstPtr scan;
  double time = 0;  ///< s since the first scan; 0 where the log has no times
  std::optional<mrpt::math::TPose2D> odometry;   ///< m, rad
  std::optional<mrpt::math::TTwist2D> velocity;  ///< m/s, rad/s, robot frame
};

/// All 2D scans of a rawlog in either of MRPT's formats (observations; actions and sensory frames),
/// in file order. Velocities are those of odometry, or else differences of its poses. `label`
/// chooses one sensor by its label; empty takes all. Throws Error (File) with file and reason when
/// it is missing, damaged, cut off, or holds no such scan.
std::vector<LoggedScan> read_laser_log(const std::string& path, const std::string& label = "");

}  // namespace slalom
