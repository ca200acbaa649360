#pragma once

#include <slalom/trajectory/trajectory.h>

#include <string>
#include <vector>

namespace slalom {

/// A trajectory as some robot's log has it.
struct TrajectoryFile {
  Trajectory trajectory;
  std::vector<std::string> notes;  ///< for people: what was derived, and what is not there
};

/// Reads a log as CSV or TUM, told apart by its first line of content. Lines that are empty or
/// begin with '#' are left out. Units are s, m, rad, m/s, rad/s.
///
/// CSV: a header line with the names of the columns, in any order: t, x, y, phi; and, where the log
/// has them, v, w, vy, command_v, command_w, command_vy. TUM: t x y z qx qy qz qw, of which the
/// position in the plane and the yaw are taken.
///
/// Speeds that are not there are derived by central differences of the poses (`sideways`: vy too,
/// otherwise the robot drives along its heading); commands that are not there are NaN.
///
/// Throws Error (File) with line and what was expected: numbers that are not finite, times that do
/// not increase, unknown or repeated columns, rows of another length, fewer than 2 samples, more
/// than 5 million, more than 100 km of way, files of more than 512 MiB.
TrajectoryFile load_trajectory_file(const std::string& path, bool sideways);
TrajectoryFile trajectory_from_text(const std::string& text, const std::string& where,
                                    bool sideways);

}  // namespace slalom
