// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/trajectory.h>

#include <limits>
#include <string>
#include <vector>

namespace slalom {

/// A trajectory read from a robot's log.
struct TrajectoryFile {
  Trajectory trajectory;
  /// Human-readable: derived, missing and unused columns, rows that are left out, implausible
  /// units.
  std::vector<std::string> notes;
};

/// The part of a log that is read, from its time `from` to its time `to` (s), and its columns.
struct LogSelection {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  /// NAME=COLUMN[*FACTOR],...: columns that do not have the usual names or units.
  std::string columns = "";
  double rate = 0;  ///< Hz, of poses without times (KITTI, MRPT); 0: unknown
};

/// Reads a log in CSV or TUM format. Empty lines and lines that begin with '#' are ignored. Units
/// are s, m, rad, m/s, rad/s unless brackets behind the names of columns say otherwise.
///
/// The first non-empty line names the columns in any order, or the last line with '#' before
/// numbers: t, x, y, and optionally phi or a quaternion qx, qy, qz, qw, v, w, vy, command_v,
/// command_w, command_vy, or usual other names. Other columns are not read. Lines of numbers
/// without header are t x y z qx qy qz qw (TUM), t x y z yaw pitch roll or t x y phi. Lines of 12
/// numbers are poses of KITTI, rows of [R t] in the frame of a camera (x right, y down, z forward):
/// x is forward, y to the left, phi the direction of the camera; lines of 6 numbers are MRPT's
/// x y z yaw pitch roll. Times of both are those of the rate. Lines before them that begin with "%"
/// and no letter are ignored.
///
/// Missing headings are those of the motion; missing velocities are computed by central differences
/// of the poses (vy only if `sideways`, otherwise it is 0); missing commands are NaN.
///
/// A row with the time of the row before is left out, and one with "nan" in place of a number that
/// is not a command. With an end of the selection, the log ends where its time goes back.
///
/// Throws Error (File) with line and what was expected for: non-finite numbers, times that go back,
/// missing or duplicate columns, rows of a different length, fewer than 2 or more than 5 million
/// samples, paths longer than 100 km, files larger than 512 MiB; Error (Usage) for `columns`, and
/// for a rate of a log with times.
TrajectoryFile load_trajectory_file(const std::string& path, bool sideways,
                                    const LogSelection& selection = {});
/// The same of a log of several runs, each of which begins where the time goes back. Runs of one
/// sample are left out.
std::vector<TrajectoryFile> load_trajectory_runs(const std::string& path, bool sideways,
                                                 const LogSelection& selection = {});
std::vector<TrajectoryFile> trajectory_runs_from_text(const std::string& text,
                                                      const std::string& where, bool sideways,
                                                      const LogSelection& selection = {});
TrajectoryFile trajectory_from_text(const std::string& text, const std::string& where,
                                    bool sideways, const LogSelection& selection = {});

}  // namespace slalom
