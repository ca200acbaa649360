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
  /// Human-readable: derived and missing columns, rows that are left out, implausible units.
  std::vector<std::string> notes;
};

/// The part of a log that is read: from its time `from` to its time `to`, s.
struct LogSpan {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Reads a log in CSV or TUM format, detected from the first non-empty line. Empty lines and lines
/// that begin with '#' are ignored. Units are s, m, rad, m/s, rad/s.
///
/// CSV: a header line with the column names in any order: t, x, y, phi, and optionally v, w, vy,
/// command_v, command_w, command_vy. TUM: t x y z qx qy qz qw, of which x, y and the yaw are used.
///
/// Missing velocities are computed by central differences of the poses (vy only if `sideways`,
/// otherwise it is 0); missing commands are NaN.
///
/// A row with the time of the row before is left out. With an end of the span, the log ends where
/// its time goes back.
///
/// Throws Error (File) with line and what was expected for: non-finite numbers, times that go back,
/// unknown or duplicate columns, rows of a different length, fewer than 2 or more than 5 million
/// samples, paths longer than 100 km, files larger than 512 MiB.
TrajectoryFile load_trajectory_file(const std::string& path, bool sideways,
                                    const LogSpan& span = {});
TrajectoryFile trajectory_from_text(const std::string& text, const std::string& where,
                                    bool sideways, const LogSpan& span = {});

}  // namespace slalom
