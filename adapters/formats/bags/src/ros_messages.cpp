// SPDX-License-Identifier: BSD-3-Clause
#include "byte_cursor.h"

#include <slalom/bags/ros_messages.h>
#include <slalom/core/math.h>

#include <cmath>

namespace slalom {
namespace {

/// Reads the members that messages share.
class MessageCursor : public ByteCursor {
 public:
  explicit MessageCursor(const BagMessage& message)
      : ByteCursor(payload(message), message.place, layout(message)),
        has_sequence_(message.topic.encoding == "ros1") {}

  std::int64_t stamp() {
    constexpr std::int64_t kNanoseconds = 1'000'000'000;
    const std::int64_t seconds = get<std::int32_t>();
    return kNanoseconds * seconds + get<std::uint32_t>();
  }
  std::string frame() {
    std::string_view frame = text();
    if (!frame.empty() && frame.front() == '/') frame.remove_prefix(1);
    return std::string(frame);
  }
  RosHeader header() {
    if (has_sequence_) get<std::uint32_t>();
    RosHeader header;
    header.stamp = stamp();
    header.frame = frame();
    return header;
  }
  RosPose pose() {
    RosPose pose;
    for (double* number : {&pose.x, &pose.y, &pose.z, &pose.qx, &pose.qy, &pose.qz, &pose.qw})
      *number = get<double>();
    return pose;
  }
  RosTwist twist() {
    RosTwist twist;
    twist.vx = get<double>();
    twist.vy = get<double>();
    skip_doubles(3);
    twist.wz = get<double>();
    return twist;
  }
  RosStampedPose stamped_pose() {
    RosStampedPose stamped;
    stamped.header = header();
    stamped.pose = pose();
    return stamped;
  }
  void skip_doubles(int count) {
    for (int i = 0; i < count; ++i) get<double>();
  }

 private:
  static constexpr std::size_t kRepresentation = 4;  ///< bytes before a message in CDR

  static std::string_view payload(const BagMessage& message) {
    return message.topic.encoding == "cdr"
               ? message.data.substr(std::min(kRepresentation, message.data.size()))
               : message.data;
  }

  static ByteLayout layout(const BagMessage& message) {
    const std::string& encoding = message.topic.encoding;
    if (encoding == "ros1") return ByteLayout::Packed;
    if (encoding != "cdr")
      throw message.place.error("'" + message.topic.name + "' is encoded as '" + encoding + "'",
                                "cdr or ros1");
    const std::string_view bytes = message.data.substr(0, kRepresentation);
    if (bytes.size() < kRepresentation || bytes[0] != 0 || (bytes[1] != 0 && bytes[1] != 1))
      throw message.place.error("'" + message.topic.name + "' is not plain CDR",
                                "a message that begins with 00 00 or 00 01");
    return bytes[1] == 0 ? ByteLayout::CdrBigEndian : ByteLayout::CdrLittleEndian;
  }

  bool has_sequence_;  ///< headers of ROS 1 begin with a number
};

template <std::size_t count>
void expect_type(const BagMessage& message, const std::array<const char*, count>& types) {
  if (!is_one_of(types, message.topic.type))
    throw message.place.error("'" + message.topic.name + "' is of type " + message.topic.type,
                              types[0]);
}

}  // namespace

bool RosPose::is_valid() const {
  constexpr double kTolerance = 0.1;  // as that of tf2
  const double norm = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) &&
         std::abs(norm - 1) < kTolerance;
}

double RosPose::yaw() const {
  return math::atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

RosScan decode_scan(const BagMessage& message) {
  expect_type(message, kScanTypes);
  MessageCursor cursor(message);
  RosScan scan;
  scan.header = cursor.header();
  scan.angle_min = cursor.get<float>();
  cursor.get<float>();  // angle_max, which some drivers set to that of one ray more
  scan.angle_increment = cursor.get<float>();
  cursor.get<float>();  // time_increment
  cursor.get<float>();  // scan_time
  scan.range_min = cursor.get<float>();
  scan.range_max = cursor.get<float>();
  scan.ranges = cursor.sequence<float>();
  return scan;
}

RosOdometry decode_odometry(const BagMessage& message) {
  expect_type(message, kOdometryTypes);
  MessageCursor cursor(message);
  RosOdometry odometry;
  odometry.header = cursor.header();
  odometry.child_frame = cursor.frame();
  odometry.pose = cursor.pose();
  constexpr int kCovariance = 36;
  cursor.skip_doubles(kCovariance);
  odometry.twist = cursor.twist();
  return odometry;
}

RosStampedPose decode_pose(const BagMessage& message) {
  expect_type(message, kPoseTypes);
  return MessageCursor(message).stamped_pose();
}

std::vector<RosTransform> decode_transforms(const BagMessage& message) {
  expect_type(message, kTransformTypes);
  MessageCursor cursor(message);
  constexpr std::size_t kMinSize = 72;  // bytes: stamp, two empty texts, seven numbers
  std::vector<RosTransform> transforms(cursor.count(kMinSize));
  for (RosTransform& transform : transforms) {
    transform.header = cursor.header();
    transform.child_frame = cursor.frame();
    transform.pose = cursor.pose();
  }
  return transforms;
}

RosTwist decode_twist(const BagMessage& message) {
  expect_type(message, kTwistTypes);
  MessageCursor cursor(message);
  std::optional<RosHeader> header;
  if (message.topic.type == kTwistTypes[1]) header = cursor.header();
  RosTwist twist = cursor.twist();
  twist.header = std::move(header);
  return twist;
}

RosGrid decode_grid(const BagMessage& message) {
  expect_type(message, kGridTypes);
  MessageCursor cursor(message);
  RosGrid grid;
  grid.header = cursor.header();
  cursor.stamp();  // when the map was loaded
  grid.resolution = cursor.get<float>();
  grid.width = cursor.get<std::uint32_t>();
  grid.height = cursor.get<std::uint32_t>();
  grid.origin = cursor.pose();
  grid.cells = cursor.sequence<std::int8_t>();
  if (grid.cells.size() != std::uint64_t{grid.width} * grid.height)
    throw message.place.error(std::to_string(grid.cells.size()) + " cells",
                              std::to_string(grid.width) + " x " + std::to_string(grid.height));
  return grid;
}

RosPath decode_path(const BagMessage& message) {
  expect_type(message, kPathTypes);
  MessageCursor cursor(message);
  RosPath path;
  path.header = cursor.header();
  constexpr std::size_t kMinSize = 68;  // bytes: stamp, an empty text, seven numbers
  path.poses.resize(cursor.count(kMinSize));
  for (RosStampedPose& pose : path.poses) pose = cursor.stamped_pose();
  return path;
}

std::optional<RosHeader> decode_header(const BagMessage& message) {
  const std::string& type = message.topic.type;
  const bool has_header = is_one_of(kScanTypes, type) || is_one_of(kOdometryTypes, type) ||
                          is_one_of(kPoseTypes, type) || type == kTwistTypes[1] ||
                          is_one_of(kGridTypes, type) || is_one_of(kPathTypes, type);
  if (!has_header) return std::nullopt;
  return MessageCursor(message).header();
}

}  // namespace slalom
