// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/bags/bag.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The messages of ROS that are read, without the members that are not used. The definitions are
/// those of common_interfaces (ROS 2) and common_msgs (ROS 1), the same but for the header.

/// A stamp, and the frame of the data without the leading slash of old versions of ROS.
struct RosHeader {
  std::int64_t stamp = 0;  ///< ns
  std::string frame;
};

struct RosPose {
  double x = 0, y = 0, z = 0;             ///< m
  double qx = 0, qy = 0, qz = 0, qw = 1;  ///< of a unit quaternion, unless it is damaged
  bool is_valid() const;                  ///< finite numbers, a quaternion of length 1
  double yaw() const;                     ///< rad; heading of the x axis in the plane
};

struct RosTwist {
  std::optional<RosHeader> header;  ///< of TwistStamped
  double vx = 0, vy = 0, wz = 0;    ///< m/s, rad/s
};

struct RosScan {
  RosHeader header;
  double angle_min = 0, angle_increment = 0;  ///< rad; the increment can be negative
  double range_min = 0, range_max = 0;        ///< m
  std::vector<float> ranges;
};

struct RosOdometry {
  RosHeader header;
  std::string child_frame;  ///< of the twist
  RosPose pose;
  RosTwist twist;
};

struct RosStampedPose {
  RosHeader header;
  RosPose pose;
};

struct RosTransform {
  RosHeader header;
  std::string child_frame;
  RosPose pose;  ///< of the child's frame in that of the header
};

struct RosGrid {
  RosHeader header;
  double resolution = 0;  ///< m
  std::uint32_t width = 0, height = 0;
  RosPose origin;
  std::vector<std::int8_t> cells;  ///< width * height; -1 unknown, 0 to 100 occupied
};

struct RosPath {
  RosHeader header;
  std::vector<RosStampedPose> poses;
};

/// The types that each function decodes.
constexpr std::array<const char*, 1> kScanTypes = {"sensor_msgs/LaserScan"};
constexpr std::array<const char*, 1> kOdometryTypes = {"nav_msgs/Odometry"};
constexpr std::array<const char*, 2> kPoseTypes = {"geometry_msgs/PoseStamped",
                                                   "geometry_msgs/PoseWithCovarianceStamped"};
constexpr std::array<const char*, 2> kTransformTypes = {"tf2_msgs/TFMessage", "tf/tfMessage"};
constexpr std::array<const char*, 2> kTwistTypes = {"geometry_msgs/Twist",
                                                    "geometry_msgs/TwistStamped"};
constexpr std::array<const char*, 1> kGridTypes = {"nav_msgs/OccupancyGrid"};
constexpr std::array<const char*, 1> kPathTypes = {"nav_msgs/Path"};

template <std::size_t count>
bool is_one_of(const std::array<const char*, count>& types, const std::string& type) {
  for (const char* one : types)
    if (type == one) return true;
  return false;
}

/// Decode a message of CDR or of ROS 1. Throw Error (File) if it is of another type or encoding, is
/// too short, or states more elements than it has bytes.
RosScan decode_scan(const BagMessage& message);
RosOdometry decode_odometry(const BagMessage& message);
RosStampedPose decode_pose(const BagMessage& message);
std::vector<RosTransform> decode_transforms(const BagMessage& message);
RosTwist decode_twist(const BagMessage& message);
RosGrid decode_grid(const BagMessage& message);
RosPath decode_path(const BagMessage& message);

/// The header of a message that begins with one; none of types that do not or are not known.
std::optional<RosHeader> decode_header(const BagMessage& message);

}  // namespace slalom
