// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/ros_messages.h>

#include <string>
#include <vector>

namespace slalom {

/// A disc of visualization_msgs/Marker.
struct RosMarker {
  RosHeader header;
  std::string name;  ///< its namespace
  RosPose pose;
  double diameter = 0, height = 0;  ///< m
  bool removed = false;             ///< the disc of this name is to vanish
};

/// Encode a message in CDR, little-endian, as the nodes of ROS 2 publish it: LaserScan, Odometry,
/// TFMessage, PoseStamped, TwistStamped (with a header) or Twist, OccupancyGrid, MarkerArray.
/// Members that are not in the structures are zero; covariances, too.
std::string encode(const RosScan& scan);
std::string encode(const RosOdometry& odometry);
std::string encode(const std::vector<RosTransform>& transforms);
std::string encode(const RosStampedPose& pose);
std::string encode(const RosTwist& twist);
std::string encode(const RosGrid& grid);
std::string encode(const std::vector<RosMarker>& markers);

/// The definition of a type that is encoded, "sensor_msgs/LaserScan", followed by those of the
/// types of its members, in the format of the .msg files of ROS 2 ("ros2msg" of MCAP).
std::string definition_of(const std::string& type);

}  // namespace slalom
