// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <vector>

namespace slalom {

/// The topics of a bag that become observations; empty: the only one of the types that fit.
struct BagSelection {
  std::string scan;      ///< LaserScan
  std::string odometry;  ///< Odometry; if there is none, the transform from "odom" to the robot
  std::string command;   ///< Twist or TwistStamped
  std::string
      base;  ///< frame of the robot's center; empty: base_link, or else that of the odometry

  bool is_default() const;
};

/// The objects of a log in order.
struct LogObjects {
  std::string path;
  std::vector<mrpt::serialization::CSerializable::Ptr> objects;
  std::vector<std::string> notes;  ///< human-readable: what a bag's import assumed or left out
};

/// Reads a rawlog, also the objects within its CRawlog objects, or a bag of ROS as import_bag().
/// Throws Error (File) with file and reason if it is missing, corrupt, truncated or neither, Error
/// (Usage) for a selection of topics of a rawlog.
LogObjects load_log(const std::string& path, const BagSelection& selection = {});

/// Converts a bag of ROS to observations as those of a recorded run: scans labeled by their topic,
/// with the pose of the sensor by the transforms; odometry and commands labeled "odometry" and
/// "command". Their times are those of their headers; messages without a header have that of their
/// recording, on the clock of the headers.
///
/// Ranges that are not finite, below the sensor's range_min or above its range_max are no return.
/// Throws Error (File) as read_bag(), for topics that are missing or of another type, for several
/// ones of a type without a choice, and if none fits.
LogObjects import_bag(const std::string& path, const BagSelection& selection = {});

/// Writes a rawlog, compressed by gzip. Throws Error (Job) if it cannot be written.
void write_rawlog(const LogObjects& log, const std::string& path);

}  // namespace slalom
